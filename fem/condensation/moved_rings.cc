#include "fem/condensation/moved_rings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fretval::fem {
namespace {

constexpr Eigen::Index n_nodes = 7;  // of the polynomials through sums over rings

/// What the end of a body adds to the half-space.
Eigen::MatrixXd smooth_part(const Compliance& body) {
  const Eigen::Index n = body.areas.size();
  if (!body.half_space || body.half_space->areas.size() < n || n + 1 < n_nodes)
    throw std::invalid_argument(fmt::format(
        "the smooth part of {} rings: at least {} are needed, and a half-space with as many", n, n_nodes - 1));
  return *body.matrix - body.half_space->matrix->topLeftCorner(n, n);
}

/// Squares of the radii of rings, which an area is in proportion to.
Eigen::VectorXd squares(const std::vector<double>& radii) {
  return Eigen::Map<const Eigen::ArrayXd>(radii.data(), static_cast<Eigen::Index>(radii.size())).square();
}

/// Weights with which the integrals of a smooth function of the square of the radius over the rings between `nodes`
/// give those over the rings between `edges`: sums from the axis on are interpolated by Lagrange's polynomials through
/// the nearest nodes.
Eigen::MatrixXd weights_of(const Eigen::VectorXd& edges, const Eigen::VectorXd& nodes) {
  const Eigen::Index n = edges.size() - 1, n_rings = nodes.size() - 1;
  Eigen::MatrixXd at_edges = Eigen::MatrixXd::Zero(n + 1, n_rings + 1);
  for (Eigen::Index k = 0; k <= n; ++k) {
    const Eigen::Index above = std::upper_bound(nodes.begin(), nodes.end(), edges[k]) - nodes.begin(),
                       first = std::clamp<Eigen::Index>(above - n_nodes / 2, 0, n_rings + 1 - n_nodes);
    for (Eigen::Index i = first; i < first + n_nodes; ++i) {
      double& weight = at_edges(k, i) = 1;
      for (Eigen::Index j = first; j < first + n_nodes; ++j)
        if (j != i) weight *= (edges[k] - nodes[j]) / (nodes[i] - nodes[j]);
    }
  }
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(n_rings + 1, n_rings);
  sums.bottomRows(n_rings).triangularView<Eigen::Lower>().setOnes();
  return (at_edges.bottomRows(n) - at_edges.topRows(n)) * sums;
}

}  // namespace

Compliance moved_rings(const Compliance& compliance, const Compliance& coarse, double factor) {
  const auto smooth = smooth_part(coarse);
  const Eigen::VectorXd nodes = squares(coarse.radii), edges = squares(compliance.radii);
  const auto of_rings = weights_of(edges, nodes), of_moved = weights_of(std::pow(factor, 2) * edges, nodes);
  auto moved = compliance;
  moved.matrix = SharedMatrix(Eigen::MatrixXd(*compliance.matrix - of_rings * smooth * of_rings.transpose()));
  moved = scaled(moved, factor);
  moved.matrix = SharedMatrix(Eigen::MatrixXd(*moved.matrix + of_moved * smooth * of_moved.transpose()));
  return moved;
}

}  // namespace fretval::fem
