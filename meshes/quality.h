#pragma once

#include <cstddef>

#include "meshes/mesh.h"

namespace fretval::meshes {

struct MeshQuality {
  std::size_t n_cells;
  std::size_t n_nodes;
  double min_scaled_jacobian;  ///< over all cells, see `scaled_jacobian`
  double mean_scaled_jacobian;
  double max_aspect_ratio;  ///< longest over shortest edge of a cell
  double area;              ///< sum over cells, unit of the nodes squared
  double smallest_edge;     ///< unit of the nodes
  double largest_edge;      ///< unit of the nodes
};

/// Smallest over the four corners of (e1 x e2)/(|e1||e2|), e1 and e2 the edges that leave the corner,
/// counter-clockwise: 1 for a rectangle, positive for a convex cell, at most 0 for an inverted, bow-tie or collapsed
/// one (NaN if an edge has no length).
double scaled_jacobian(const Mesh& mesh, const std::array<unsigned, 4>& cell);

/// Area of a cell by the shoelace formula, negative if it is clockwise.
double signed_area(const Mesh& mesh, const std::array<unsigned, 4>& cell);

/// Statistics over all cells of a mesh with at least one cell; indices must be valid.
MeshQuality quality(const Mesh& mesh);

}  // namespace fretval::meshes
