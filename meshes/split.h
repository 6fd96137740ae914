#pragma once

#include <array>
#include <vector>

#include "meshes/coarse_mesh.h"

namespace fretval::meshes {

/// Quadrilaterals alone, with the sides of the quarter disc.
struct SplitMesh {
  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<unsigned, 4>> cells;  ///< counter-clockwise
  std::vector<CoarseMesh::Edge> edges;
};

/// Splits every polygon into quadrilaterals, one at each corner, that meet in the mean of its corners; edges are split
/// at their middle. The nodes of the coarse mesh come first, then those on edges, then one per polygon.
SplitMesh split(const CoarseMesh& coarse);

}  // namespace fretval::meshes
