#include "meshes/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fretval::meshes {
namespace {

std::array<double, 2> difference(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return {a[0] - b[0], a[1] - b[1]};
}

double cross(const std::array<double, 2>& a, const std::array<double, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}

double length(const std::array<double, 2>& a) {
  return std::hypot(a[0], a[1]);
}

}  // namespace

double scaled_jacobian(const Mesh& mesh, const std::array<unsigned, 4>& cell) {
  double smallest = 1.;
  for (int i = 0; i < 4; ++i) {
    const auto& corner = mesh.nodes[cell[i]];
    const auto next = difference(mesh.nodes[cell[(i + 1) % 4]], corner);
    const auto previous = difference(mesh.nodes[cell[(i + 3) % 4]], corner);
    const double jacobian = cross(next, previous) / (length(next) * length(previous));
    // Written so that NaN is kept, not dropped as std::min would.
    if (!(jacobian >= smallest)) smallest = jacobian;
    if (std::isnan(smallest)) break;
  }
  return smallest;
}

double signed_area(const Mesh& mesh, const std::array<unsigned, 4>& cell) {
  return cross(difference(mesh.nodes[cell[2]], mesh.nodes[cell[0]]),
               difference(mesh.nodes[cell[3]], mesh.nodes[cell[1]])) /
         2.;
}

MeshQuality quality(const Mesh& mesh) {
  MeshQuality quality{mesh.cells.size(), mesh.nodes.size(), 1., 0., 1., 0., std::numeric_limits<double>::max(), 0.};
  for (const auto& cell : mesh.cells) {
    const double jacobian = scaled_jacobian(mesh, cell);
    std::array<double, 4> lengths{};
    for (int i = 0; i < 4; ++i) lengths[i] = length(difference(mesh.nodes[cell[(i + 1) % 4]], mesh.nodes[cell[i]]));
    const auto [shortest, longest] = std::minmax_element(lengths.begin(), lengths.end());
    quality.min_scaled_jacobian = std::min(quality.min_scaled_jacobian, jacobian);
    quality.mean_scaled_jacobian += jacobian / mesh.cells.size();
    quality.max_aspect_ratio = std::max(quality.max_aspect_ratio, *longest / *shortest);
    quality.area += signed_area(mesh, cell);
    quality.smallest_edge = std::min(quality.smallest_edge, *shortest);
    quality.largest_edge = std::max(quality.largest_edge, *longest);
  }
  return quality;
}

}  // namespace fretval::meshes
