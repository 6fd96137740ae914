#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "comparison/report/text/filling.h"

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

}  // namespace fretval
