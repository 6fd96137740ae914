#include "mdr/non_negative_least_squares.h"

#include <Eigen/QR>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace fretval::mdr {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct ActiveSet {
  VectorXd x;
  std::vector<Index> in_use;  // columns with x_j > 0
};

void require_valid(const MatrixXd& A, const VectorXd& b) {
  if (A.rows() < 1 || A.cols() < 1 || A.rows() != b.size()) {
    throw std::invalid_argument("least squares with a matrix of " + std::to_string(A.rows()) + " x " +
                                std::to_string(A.cols()) + " and a right-hand side of " + std::to_string(b.size()) +
                                ": must have as many rows, and at least one column");
  }
  if (!A.allFinite() || !b.allFinite()) {
    throw std::invalid_argument("least squares: matrix and right-hand side must be finite");
  }
}

// Unconstrained solution in the columns in use.
VectorXd free_solution(const MatrixXd& A, const VectorXd& b, const std::vector<Index>& in_use) {
  if (in_use.empty()) return {};
  return A(Eigen::all, in_use).colPivHouseholderQr().solve(b);
}

// Unused column of steepest descent that would become positive, or -1.
Index entering_column(const MatrixXd& A, const VectorXd& b, const ActiveSet& set, double tolerance) {
  VectorXd descent = A.transpose() * (b - A * set.x);
  for (const Index j : set.in_use) descent(j) = 0;
  while (true) {
    Index j;
    if (descent.maxCoeff(&j) <= tolerance) return -1;
    std::vector<Index> wider = set.in_use;
    wider.push_back(j);
    // Descent of a column nearly dependent on those in use may be roundoff: then its coefficient is not positive.
    if (free_solution(A, b, wider).tail<1>()(0) > 0) return j;
    descent(j) = 0;
  }
}

// Goes from x towards the free solution until the first coefficient vanishes, and drops what has vanished.
void step_to_boundary(ActiveSet& set, const VectorXd& target) {
  double step = 1;
  for (std::size_t k = 0; k < set.in_use.size(); ++k) {
    const double x = set.x(set.in_use[k]), z = target(static_cast<Index>(k));
    if (z <= 0) step = std::min(step, x / (x - z));
  }
  std::vector<Index> kept;
  for (std::size_t k = 0; k < set.in_use.size(); ++k) {
    double& x = set.x(set.in_use[k]);
    const double z = target(static_cast<Index>(k));
    const bool vanishes = z <= 0 && x / (x - z) <= step;
    x = vanishes ? 0 : x + step * (z - x);
    if (x > 0) kept.push_back(set.in_use[k]);
  }
  set.in_use = kept;
}

}  // namespace

VectorXd non_negative_least_squares(const MatrixXd& A, const VectorXd& b, int max_iterations) {
  require_valid(A, b);
  // With unit columns and right-hand side one tolerance serves every column.
  const double size = b.stableNorm();
  VectorXd norms = A.colwise().stableNorm();
  norms = (norms.array() > 0).select(norms, 1);
  if (size == 0) return VectorXd::Zero(A.cols());
  const MatrixXd unit_A = A * norms.cwiseInverse().asDiagonal();
  const VectorXd unit_b = b / size;
  const double tolerance = 10 * static_cast<double>(A.rows()) * std::numeric_limits<double>::epsilon();

  ActiveSet set{VectorXd::Zero(A.cols()), {}};
  const Index n_iterations = max_iterations > 0 ? max_iterations : 30 * A.cols();
  for (Index i = 0; i < n_iterations; ++i) {
    const Index entering = entering_column(unit_A, unit_b, set, tolerance);
    if (entering < 0) return size * set.x.cwiseQuotient(norms);
    set.in_use.push_back(entering);
    VectorXd target = free_solution(unit_A, unit_b, set.in_use);
    while (!set.in_use.empty() && target.minCoeff() <= 0) {
      step_to_boundary(set, target);
      target = free_solution(unit_A, unit_b, set.in_use);
    }
    for (std::size_t k = 0; k < set.in_use.size(); ++k) set.x(set.in_use[k]) = target(static_cast<Index>(k));
  }
  throw std::runtime_error("non-negative least squares: active set not found in " + std::to_string(n_iterations) +
                           " changes");
}

}  // namespace fretval::mdr
