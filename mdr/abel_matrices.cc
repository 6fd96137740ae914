#include "mdr/abel_matrices.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fretval::mdr {

namespace {
const double pi = std::acos(-1.0);

double arcosine(double x, double r) {  // arccos(x/r)
  x = std::max(x, 0.0);
  return std::atan2(std::sqrt((r - x) * (r + x)), x);
}

Eigen::MatrixXd image_matrix(const Eigen::ArrayXd& x) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(x.size(), x.size());
  for (Eigen::Index j = 0; j < x.size(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i) {
      const double weight = x[j] * (arcosine(x[i], x[j]) - arcosine(x[i + 1], x[j])) / (x[i + 1] - x[i]);
      matrix(j, i) -= weight;
      matrix(j, i + 1) += weight;
    }
  }
  return matrix;
}

// A step of q at x = R is a flat punch, q/(pi sqrt(R^2-r^2)), whose mean over a ring is in closed form.
Eigen::MatrixXd stress_matrix(const Eigen::ArrayXd& x, double h) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(x.size(), x.size());
  const auto root = [](double R, double r) { return std::sqrt((R - r) * (R + r)); };
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const double inner = x[i] - h / 2, outer = x[i] + h / 2;
    for (Eigen::Index j = i; j < x.size(); ++j) {
      const double R = std::max(outer, x[j] + h / 2);
      const double mean = 2 / pi * (root(R, inner) - root(R, outer)) / ((outer - inner) * (outer + inner));
      matrix(i, j) += mean;
      if (j + 1 < x.size()) matrix(i, j + 1) -= mean;
    }
  }
  return matrix;
}

Eigen::MatrixXd displacement_matrix(const Eigen::ArrayXd& x, double h) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(x.size(), x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    for (Eigen::Index j = 0; j <= i; ++j)
      matrix(i, j) = 2 / pi * (arcosine(x[j] - h / 2, x[i]) - arcosine(std::min(x[j] + h / 2, x[i]), x[i]));
  }
  return matrix;
}

}  // namespace

AbelMatrices abel_matrices(const SpringBed& bed) {
  const double h = bed.width[0];
  if ((bed.width - h).abs().maxCoeff() > 1e-12 * h)
    throw std::invalid_argument("springs of different widths: the matrices of the Abel transforms need equal ones");
  return {image_matrix(bed.position), stress_matrix(bed.position, h), displacement_matrix(bed.position, h)};
}

}  // namespace fretval::mdr
