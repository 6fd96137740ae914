#include "mdr/wear/abel_matrices.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

double root(double x, double r) {  // int x/sqrt(x^2-r^2) dx from r, the image of a step at r
  return x > r ? std::sqrt((x - r) * (x + r)) : 0;
}

// The ring is a step up at its inner edge and one down at its outer edge.
Eigen::MatrixXd image_matrix(const Eigen::ArrayXd& edge) {
  const Eigen::Index n = edge.size() - 1;
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    double below = 0;
    for (Eigen::Index j = i; j < n; ++j) {
      // Difference of the two roots without cancellation.
      const double inner = root(edge[j + 1], edge[i]), outer = root(edge[j + 1], edge[i + 1]);
      const double above = (edge[i + 1] - edge[i]) * (edge[i + 1] + edge[i]) / (inner + outer);
      matrix(j, i) = (above - below) / (edge[j + 1] - edge[j]);
      below = above;
    }
  }
  return matrix;
}

Eigen::ArrayXd interval_edges(const SpringBed& bed) {
  const Eigen::Index n = bed.width.size();
  Eigen::ArrayXd edge(n + 1);
  edge[0] = 0;
  for (Eigen::Index j = 0; j < n; ++j) {
    edge[j + 1] = bed.position[j] + bed.width[j] / 2;
    // Positions come from sums of widths: 1e-9 of the bed is far above their roundoff.
    if (!(bed.width[j] > 0) || std::abs(edge[j + 1] - edge[j] - bed.width[j]) > 1e-9 * edge[j + 1])
      throw std::invalid_argument(
          "intervals of the springs overlap or leave gaps: the Abel matrices need them to "
          "follow each other from the axis");
  }
  return edge;
}

}  // namespace

AbelMatrices abel_matrices(const SpringBed& bed) {
  const Eigen::ArrayXd edge = interval_edges(bed);
  const Eigen::Index n = bed.width.size();
  AbelMatrices matrices;
  matrices.area = pi * (edge.tail(n) - edge.head(n)) * (edge.tail(n) + edge.head(n));
  matrices.image = image_matrix(edge);
  matrices.stress =
      (1 / matrices.area).matrix().asDiagonal() * matrices.image.transpose() * (2 * bed.width).matrix().asDiagonal();
  matrices.displacement = matrices.image.triangularView<Eigen::Lower>().solve(Eigen::MatrixXd::Identity(n, n));
  return matrices;
}

}  // namespace fretval::mdr
