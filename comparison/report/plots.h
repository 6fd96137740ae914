#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fretval {

/// One curve or set of points; NaN values leave a gap.
struct Series {
  enum class Style { line, dashed, line_points, points, open_points, triangles };
  std::string label;  ///< empty: not in the key
  std::vector<double> x, y;
  Style style = Style::line;
  int colour = 0;  ///< index into the palette
};

struct Plot {
  std::string title, x_label, y_label;
  std::vector<Series> series = {};
  bool log_y = false;
  bool key_right = false;  ///< key on the right rather than below
  std::optional<std::pair<double, double>> x_range = {}, y_range = {};
  bool log_x = false;
  std::vector<double> x_tics = {};  ///< empty: where gnuplot puts them
};

/// Draws plots with gnuplot as SVG elements to embed in HTML. Throws std::runtime_error if gnuplot is missing or
/// refuses.
std::vector<std::string> svgs(const std::vector<Plot>& plots);

}  // namespace fretval
