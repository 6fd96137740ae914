#include "mdr/support/non_negative_least_squares.h"

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

// Takes the unused column of steepest descent into use, with the free solution as target. False if there is none.
bool enter_column(const MatrixXd& A, const VectorXd& b, ActiveSet& set, VectorXd& target) {
  const double tolerance = 10 * static_cast<double>(A.rows()) * std::numeric_limits<double>::epsilon();
  VectorXd descent = A.transpose() * (b - A * set.x);
  for (const Index j : set.in_use) descent(j) = 0;
  while (true) {
    Index j;
    if (descent.maxCoeff(&j) <= tolerance) return false;
    set.in_use.push_back(j);
    target = free_solution(A, b, set.in_use);
    // Descent of a column nearly dependent on those in use may be roundoff: then its coefficient is not positive.
    if (target.tail<1>()(0) > 0) return true;
    set.in_use.pop_back();
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

// Brings the problem to no more rows than columns: A = Q R leaves |R x - Q^T b| to minimise.
void compress(MatrixXd& A, VectorXd& b) {
  if (A.rows() <= A.cols()) return;
  const Eigen::HouseholderQR<MatrixXd> factors(A);
  b = (factors.householderQ().adjoint() * b).eval().head(A.cols()).eval();
  A = factors.matrixQR().topRows(A.cols()).triangularView<Eigen::Upper>();
}

}  // namespace

VectorXd non_negative_least_squares(const MatrixXd& A, const VectorXd& b, int max_iterations) {
  require_valid(A, b);
  const double size = b.stableNorm();
  if (size == 0) return VectorXd::Zero(A.cols());
  // With unit columns and right-hand side one tolerance serves every column.
  VectorXd norms = A.colwise().stableNorm();
  norms = (norms.array() > 0).select(norms, 1);
  MatrixXd unit_A = A * norms.cwiseInverse().asDiagonal();
  VectorXd unit_b = b / size;
  compress(unit_A, unit_b);

  ActiveSet set{VectorXd::Zero(A.cols()), {}};
  VectorXd target;
  const Index n_iterations = max_iterations > 0 ? max_iterations : 30 * A.cols();
  for (Index i = 0; i < n_iterations; ++i) {
    if (!enter_column(unit_A, unit_b, set, target)) return size * set.x.cwiseQuotient(norms);
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
