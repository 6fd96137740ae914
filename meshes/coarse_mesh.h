#pragma once

#include <array>
#include <functional>
#include <vector>

namespace fretval::meshes {

/// Sides of the quarter disc as geometry: surface z = 0, arc of the far radius, axis r = 0.
enum class Side { surface, arc, axis };

/// Triangles and quadrilaterals of the quarter disc, before they are split to quadrilaterals alone.
struct CoarseMesh {
  struct Edge {
    std::array<unsigned, 2> nodes;
    Side side;
  };

  std::vector<std::array<double, 2>> nodes;     ///< (r, z)
  std::vector<std::vector<unsigned>> polygons;  ///< three or four nodes each, counter-clockwise
  std::vector<Edge> edges;
};

/// Meshes the quarter disc. surface_nodes: r of nodes that the surface must have, 0 first, strictly increasing, below
/// far_radius, with no other node between them. size(r, z): wanted size, in the same unit. strip_height: of a row of
/// rectangles under these nodes, one each; 0: none. The rest is meshed with gmsh.
/// Throws MeshError if gmsh fails. Threads wait for each other, see `quarter_disc`.
CoarseMesh coarse_mesh(const std::vector<double>& surface_nodes, double strip_height, double far_radius,
                       const std::function<double(double r, double z)>& size);

}  // namespace fretval::meshes
