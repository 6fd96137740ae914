#pragma once

#include <vector>

#include "meshes/mesh.h"

namespace fretval::meshes {

/// A mesh of triangles and quadrilaterals, with the material of each; see Mesh.
struct MixedMesh {
  std::vector<std::array<double, 2>> nodes;
  std::vector<std::vector<unsigned>> polygons;  ///< three or four nodes each, counter-clockwise
  std::vector<Mesh::Edge> edges;
  std::vector<std::string> materials;
  std::vector<unsigned> material;  ///< of each polygon
};

/// Quadrilaterals alone: one at each corner of every triangle and quadrilateral, that meet in the mean of its corners
/// and in the middles of its edges. The body and its materials stay the same; contact edges get half as wide.
Mesh split(const MixedMesh& mixed);

/// Every cell split into four. Edges are straight, so the body stays the same.
Mesh refined(const Mesh& mesh);

}  // namespace fretval::meshes
