#include "comparison/model_error/level_lines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fretval {
namespace {

constexpr int n_across = 32;

struct Corner {
  double x, y, height;
};

/// The piece of a line at a height of 0 in a triangle, if there is one.
void add_piece(const std::array<Corner, 3>& corners, LevelLine& line) {
  std::vector<std::pair<double, double>> ends;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if (std::isnan(a.height) || std::isnan(b.height) || (a.height < 0) == (b.height < 0)) continue;
    const double share = a.height / (a.height - b.height);
    ends.emplace_back(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y));
  }
  if (ends.size() != 2) return;
  for (const auto& [x, y] : ends) {
    line.x.push_back(x);
    line.y.push_back(y);
  }
  line.x.push_back(std::nan(""));
  line.y.push_back(std::nan(""));
}

double largest_value(const std::vector<MapPoint>& points, MapKind kind) {
  double largest = kind == MapKind::phase ? 180 : 0;
  for (const auto& point : points)
    if (point.map == name_of(kind) && kind != MapKind::phase)
      largest =
          std::max(largest, kind == MapKind::poisson_ratio ? point.own.poisson_ratio : point.own.radius_over_thickness);
  return largest;
}

using Grid = std::vector<std::vector<Corner>>;

Grid grid_of(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity) {
  const double top = largest_value(points, kind);
  Grid grid(n_across + 1);
  for (int i = 0; i <= n_across; ++i)
    for (int j = 0; j <= n_across; ++j) {
      const double x = least_mapped_ratio + (most_mapped_ratio - least_mapped_ratio) * i / n_across,
                   y = top * j / n_across;
      const auto off = own_off_by_on_map(points, kind, quantity, x, y);
      grid[i].push_back({x, y, off ? off->value : std::nan("")});
    }
  return grid;
}

void add_line(const Grid& grid, double level, LevelLine& line) {
  for (int i = 0; i < n_across; ++i)
    for (int j = 0; j < n_across; ++j) {
      const auto corner = [&](int right, int up) {
        auto one = grid[i + right][j + up];
        one.height -= level;
        return one;
      };
      add_piece({corner(0, 0), corner(1, 0), corner(1, 1)}, line);
      add_piece({corner(0, 0), corner(1, 1), corner(0, 1)}, line);
    }
}

}  // namespace

std::vector<LevelLine> level_lines(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                   const std::vector<double>& levels) {
  const auto grid = grid_of(points, kind, quantity);
  std::vector<LevelLine> lines(levels.size());
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (const double side : {levels[k], -levels[k]}) add_line(grid, side, lines[k]);
  return lines;
}

}  // namespace fretval
