#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace fretval::meshes {

/// Sides of a section by their geometry: the surface z = 0, the axis r = 0, and the arc, or flat base and side, at
/// which it ends.
enum class Side { surface, arc, axis, base, side };

/// How a section r >= 0, z <= 0 ends below and outside.
struct Outline {
  double radius;                         ///< of an arc around the origin or, with a thickness, of a side
  std::optional<double> thickness = {};  ///< down to a flat base; empty: the section ends with the arc
};

/// Triangles and quadrilaterals of a section, before they are split to quadrilaterals alone.
struct CoarseMesh {
  struct Edge {
    std::array<unsigned, 2> nodes;
    Side side;
  };

  std::vector<std::array<double, 2>> nodes;     ///< (r, z)
  std::vector<std::vector<unsigned>> polygons;  ///< three or four nodes each, counter-clockwise
  std::vector<Edge> edges;
};

/// Meshes a section. surface_nodes: r of nodes that the surface must have, 0 first, strictly increasing, below the
/// radius of the outline, with no other node between them. size(r, z): wanted size, in the same unit. strip_height:
/// height of a row of rectangles below the surface, one under each interval between these nodes, less than the
/// thickness; 0: none. The rest is meshed with gmsh. Throws MeshError if gmsh fails. Threads wait for each other, see
/// `body_mesh`.
CoarseMesh coarse_mesh(const std::vector<double>& surface_nodes, double strip_height, const Outline& outline,
                       const std::function<double(double r, double z)>& size);

}  // namespace fretval::meshes
