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

std::vector<double> graded_nodes(const FineBlock& block, double length, double coarse_size, double growth) {
  require(std::isfinite(length) && length > 0., "length", length, "positive");
  require(block.inner >= 0. && block.inner <= length, "inner end of the block", block.inner,
          "between 0 and the length");
  require(block.outer >= block.inner && block.outer <= length, "outer end of the block", block.outer,
          "between the inner end and the length");
  require(block.size >= 1e-9 * length && std::isfinite(block.size), "fine size", block.size,
          "at least 1e-9 of the length");
  require(coarse_size >= block.size, "coarse size", coarse_size, "at least the fine size");
  require(growth >= 0. && std::isfinite(growth), "growth", growth, "at least 0");

  std::vector<double> nodes;
  const auto inner = graded_side(block.inner, coarse_size, block.size, growth);
  for (auto distance = inner.rbegin(); distance != inner.rend(); ++distance) nodes.push_back(block.inner - *distance);
  nodes.push_back(block.inner);
  const double width = block.outer - block.inner;
  const auto n = static_cast<unsigned>(std::ceil(width / block.size * (1. - 1e-12)));
  for (unsigned i = 1; i <= n; ++i) nodes.push_back(i == n ? block.outer : block.inner + width * i / n);
  for (const double distance : graded_side(length - block.outer, coarse_size, block.size, growth))
    nodes.push_back(block.outer + distance);
  nodes.front() = 0.;
  nodes.back() = length;
  return nodes;
}

}  // namespace fretval::meshes
