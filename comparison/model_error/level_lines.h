#pragma once

#include <vector>

#include "comparison/model_error/model_error.h"

namespace fretval {

/// The stick ratios that the maps reach from and to.
constexpr double least_mapped_ratio = 0.2, most_mapped_ratio = 0.95;

/// Pieces of a line, a gap (NaN) after each.
struct LevelLine {
  std::vector<double> x, y;
};

/// Where on a map MDR over an incompressible half-space is off by each of the levels, to either side: x over the stick
/// ratio, y over the other coordinate. Straight in the triangles of a regular grid.
std::vector<LevelLine> level_lines(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                                   const std::vector<double>& levels);

/// Oblique lines over the part of a map whose nearest computed point has a bar of more than a tenth of what it shows.
LevelLine hatching(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity);

}  // namespace fretval
