#include "meshes/grading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshes/mesh_error.h"

namespace fretval::meshes {
namespace {

void require(bool valid, const char* quantity, double value, const char* valid_values) {
  if (!valid)
    throw MeshError(fmt::format("nodes of the contact line: {} is {}, must be {}", quantity, value, valid_values));
}

/// Distances from the edge of the nodes of one side, increasing, without the 0 of the edge itself.
std::vector<double> graded_side(double length, double coarse_size, double fine_size, double growth) {
  constexpr std::size_t n_max = 100000;
  std::vector<double> distances;
  double sum = 0.;
  double size = fine_size;
  // A remainder at the level of roundoff is no reason for another element.
  while (sum < length * (1. - 1e-12)) {
    if (distances.size() == n_max)
      throw MeshError(
          fmt::format("nodes of the contact line: fine size {} and growth {} need more than {} elements "
                      "on a length of {}, enlarge one of them",
                      fine_size, growth, n_max, length));
    sum += size;
    distances.push_back(sum);
    size = std::min(size * (1. + growth), coarse_size);
  }
  for (double& distance : distances) distance *= length / sum;
  return distances;
}

}  // namespace

std::vector<double> uniform_nodes(double length, unsigned n) {
  require(std::isfinite(length) && length > 0., "length", length, "positive");
  require(n >= 1, "number of elements", n, "at least 1");
  std::vector<double> nodes(n + 1);
  for (unsigned i = 0; i <= n; ++i) nodes[i] = length * i / n;
  return nodes;
}

std::vector<double> graded_nodes(double edge_radius, double length, double coarse_size, double fine_size,
                                 double growth) {
  require(std::isfinite(length) && length > 0., "length", length, "positive");
  require(edge_radius >= 0. && edge_radius <= length, "edge radius", edge_radius, "between 0 and the length");
  require(fine_size >= 1e-9 * length && std::isfinite(fine_size), "fine size", fine_size,
          "at least 1e-9 of the length");
  require(coarse_size >= fine_size, "coarse size", coarse_size, "at least the fine size");
  require(growth >= 0. && std::isfinite(growth), "growth", growth, "at least 0");

  std::vector<double> nodes;
  const auto inner = graded_side(edge_radius, coarse_size, fine_size, growth);
  for (auto distance = inner.rbegin(); distance != inner.rend(); ++distance) nodes.push_back(edge_radius - *distance);
  nodes.push_back(edge_radius);
  for (const double distance : graded_side(length - edge_radius, coarse_size, fine_size, growth))
    nodes.push_back(edge_radius + distance);
  nodes.front() = 0.;
  nodes.back() = length;
  return nodes;
}

}  // namespace fretval::meshes
