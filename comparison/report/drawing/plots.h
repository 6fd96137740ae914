#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// One curve or set of points; NaN values leave a gap.
struct Series {
  enum class Style { line, dashed, thin_line, line_points, points, small_points, open_points, triangles };
  std::string label;  ///< empty: not in the key
  std::vector<double> x, y;
  Style style = Style::line;
  int colour = 0;                ///< index into the palette
  std::vector<double> bar = {};  ///< half lengths of the error bars; empty: none
};

struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> series = {};
  bool log_y = false;
  std::optional<std::pair<double, double>> x_range = {}, y_range = {};
  bool log_x = false;
  std::vector<double> x_tics = {};                         ///< empty: where they fit
  std::vector<std::pair<std::string, double>> marks = {};  ///< vertical lines with a name
  bool equal_scales = false;  ///< a picture of a plane: both ranges are given, and x is widened to the same scale as y
};

/// The plot as data of the page, which report.js draws; six digits of every number.
Filling json_of(const Plot& plot);

/// The shares of each source in the bar of a quantity.
struct ShareRow {
  std::string label;
  std::vector<double> shares;  ///< where negative, to the left
  double start = 0;            ///< where the first one begins
  double bar = 0;              ///< error bar about the end of the last one
};

/// Bars of shares that add up, one for each row, as data of the page; a line marks a limit. of_what: the unit of a
/// share, shown to a reader who points at it.
Filling share_bars(const std::string& title, const std::string& label, const std::vector<std::string>& sources,
                   const std::vector<ShareRow>& rows, double limit = 1,
                   const std::string& of_what = "of the tolerance");

/// What each ring does over a period, radius over time, as data of the page: white open, blue sticks, orange and yellow
/// slip forward and backward. edges: outer radii of the rings, in the unit of the label; zones: a text for each step,
/// with a letter for each ring (see fem::WearingContact::Period::zone).
Filling zone_map(const std::string& title, const std::string& label, const std::vector<double>& edges,
                 const std::vector<std::string>& zones);

/// Outer edges of rings from the radii that halve their areas, over a unit.
std::vector<double> outer_edges(const std::vector<double>& radii, double unit);

/// A unit with the prefix that suits what is drawn in it.
struct Axis {
  std::string unit;   ///< with its prefix, "mm"
  double factor = 1;  ///< of the prefix
  [[nodiscard]] std::vector<double> of(std::vector<double> values) const;
};

/// The axis whose prefix suits the largest of all values. unit: in SI, "m".
Axis axis_for(std::initializer_list<const std::vector<double>*> all, const std::string& unit);

/// Radii that a plot over r marks: c and a.
std::vector<std::pair<std::string, double>> radius_marks(const StoredResult& result, const Axis& axis);

}  // namespace fretval
