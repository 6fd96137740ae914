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

void end_piece(LevelLine& line) {
  if (line.x.empty() || std::isnan(line.x.back())) return;
  line.x.push_back(std::nan(""));
  line.y.push_back(std::nan(""));
}

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
  end_piece(line);
}

double largest_value(const std::vector<MapPoint>& points, MapKind kind) {
  double largest = kind == MapKind::phase ? 180 : 0;
  for (const auto& point : points)
    if (point.map == name_of(kind)) largest = std::max(largest, value_on(kind, point.own));
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

/// A computed point, as shares of the width and the height of the map, and whether it is known to a tenth.
struct Dot {
  double x, y;
  bool is_known;
};

/// least: the lowest line, nearer to which nothing is shown.
std::vector<Dot> dots_of(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity, double least) {
  constexpr double known_to = 0.1;
  const double top = largest_value(points, kind);
  std::vector<Dot> dots;
  for (const auto& point : points) {
    const auto ratio = stick_ratio_for(point.own, quantity);
    const auto off = point.own_off_by(quantity);
    if (point.map != name_of(kind) || !ratio || !off) continue;
    const Dot dot{(*ratio - least_mapped_ratio) / (most_mapped_ratio - least_mapped_ratio),
                  value_on(kind, point.own) / top, off->bar <= known_to * std::max(std::abs(off->value), least)};
    dots.push_back(dot);
    if (kind == MapKind::phase && dot.y == 0) dots.push_back({dot.x, 1, dot.is_known});
  }
  return dots;
}

bool is_known_near(const std::vector<Dot>& dots, double x, double y) {
  const auto distance = [=](const Dot& dot) { return std::hypot(dot.x - x, dot.y - y); };
  const auto nearest = std::min_element(
      dots.begin(), dots.end(), [&](const Dot& one, const Dot& other) { return distance(one) < distance(other); });
  return nearest == dots.end() || nearest->is_known;
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

LevelLine hatching_of(const Grid& grid, const std::vector<Dot>& dots) {
  constexpr int apart = 2;
  LevelLine line;
  for (int offset = -n_across; offset <= n_across; offset += apart) {
    for (int i = std::max(0, offset); i <= std::min(n_across, n_across + offset); ++i) {
      const auto& [x, y, height] = grid[i][i - offset];
      const auto share = [](int n) { return static_cast<double>(n) / n_across; };
      if (std::isnan(height) || is_known_near(dots, share(i), share(i - offset))) {
        end_piece(line);
      } else {
        line.x.push_back(x);
        line.y.push_back(y);
      }
    }
    end_piece(line);
  }
  return line;
}

}  // namespace

MapLines map_lines(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                   const std::vector<double>& levels) {
  const auto grid = grid_of(points, kind, quantity);
  const double least = levels.empty() ? 0 : *std::min_element(levels.begin(), levels.end());
  MapLines lines{std::vector<LevelLine>(levels.size()), hatching_of(grid, dots_of(points, kind, quantity, least))};
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (const double side : {levels[k], -levels[k]}) add_line(grid, side, lines.levels[k]);
  return lines;
}

}  // namespace fretval
