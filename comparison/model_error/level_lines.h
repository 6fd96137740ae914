#pragma once

#include <vector>

#include "comparison/model_error/model_error.h"

namespace fretval {

/// Range of the stick ratios on the maps.
constexpr double least_mapped_ratio = 0.2, most_mapped_ratio = 0.95;

/// Pieces of a line, a gap (NaN) after each.
struct LevelLine {
  std::vector<double> x, y;
};

/// What is drawn of a map: x over the stick ratio, y over the other coordinate.
struct MapLines {
  /// Lines on which MDR over an incompressible half-space is off by each of the levels, in either direction. They are
  /// straight in the triangles of a regular grid.
  std::vector<LevelLine> levels;
  /// Oblique lines over the part whose nearest computed point has a bar of more than a tenth of what it shows, or of the
  /// lowest level where it shows less.
  LevelLine hatching;
};

MapLines map_lines(const std::vector<MapPoint>& points, MapKind kind, Quantity quantity,
                   const std::vector<double>& levels);

}  // namespace fretval
