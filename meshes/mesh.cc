#include "meshes/mesh.h"

#include <algorithm>
#include <cmath>

namespace fretval::meshes {

std::string boundary_name(Boundary boundary) {
  switch (boundary) {
    case Boundary::axis:
      return "axis";
    case Boundary::contact:
      return "contact";
    case Boundary::free:
      return "free";
    case Boundary::far:
      return "far";
    case Boundary::base:
      return "base";
  }
  return "unknown";
}

double boundary_length(const Mesh& mesh, Boundary boundary) {
  double length = 0.;
  for (const auto& edge : mesh.edges) {
    if (edge.boundary != boundary) continue;
    const auto& a = mesh.nodes[edge.nodes[0]];
    const auto& b = mesh.nodes[edge.nodes[1]];
    length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  return length;
}

std::vector<double> contact_radii(const Mesh& mesh) {
  std::vector<double> radii;
  for (const auto& edge : mesh.edges)
    if (edge.boundary == Boundary::contact)
      for (const unsigned node : edge.nodes) radii.push_back(mesh.nodes[node][0]);
  std::sort(radii.begin(), radii.end());
  radii.erase(std::unique(radii.begin(), radii.end()), radii.end());
  return radii;
}

}  // namespace fretval::meshes
