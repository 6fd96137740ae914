#include "fem/condensation/sparse_factor.h"

#include <gtest/gtest.h>

#include <thread>
#include <utility>

#include "tests/fem/expect_solver_error.h"
#include "tests/fem/random_vector.h"
#include "tests/fem/saddle_point.h"

namespace fretval::fem::sparse_factor_test {
namespace {

// Roundoff of a matrix of condition 10.
TEST(SparseFactor, SolvesASaddlePoint) {
  const Eigen::MatrixXd matrix = small_saddle_point();
  SparseFactor first(rows_of(matrix), "small");
  const SparseFactor factor = std::move(first);
  for (const unsigned seed : {1U, 2U}) {
    const Eigen::VectorXd rhs = random_vector(8, seed);
    EXPECT_LT((factor.solve(rhs) - matrix.partialPivLu().solve(rhs)).norm(), 1e-13);
  }
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(8);
  EXPECT_EQ(factor.solve(zero), zero);
}

TEST(SparseFactor, ServesThreadsAtTheSameTime) {
  std::vector<Eigen::VectorXd> residuals(4);
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < residuals.size(); ++i)
    threads.emplace_back([&residuals, i] {
      const Eigen::MatrixXd matrix = random_symmetric(60, i);
      const SparseFactor factor(rows_of(matrix), "of a thread");
      const Eigen::VectorXd rhs = random_vector(60, i);
      residuals[i] = matrix * factor.solve(rhs) - rhs;
    });
  for (auto& thread : threads) thread.join();
  for (const auto& residual : residuals) EXPECT_LT(residual.norm(), 1e-10);
}

/// A saddle point whose pivots MUMPS has to delay: zero diagonals everywhere, so that its estimate of the work space
/// is too small.
SparseMatrix delayed_pivots() {
  return rows_of(random_symmetric(600, 3));
}

// A negative spare takes away from MUMPS' estimate; INFOG(1) is then -9.
TEST(SparseFactor, GivesMumpsMoreMemoryOnce) {
  const Eigen::VectorXd rhs = random_vector(600, 2);
  const SparseFactor retried(delayed_pivots(), {}, "the pump", {-90, 60});
  const SparseFactor enough(delayed_pivots(), {}, "the pump");
  EXPECT_LT((retried.solve(rhs) - enough.solve(rhs)).norm(), 1e-10 * enough.solve(rhs).norm());
  expect_solver_error(
      [] {
        SparseFactor(delayed_pivots(), {}, "the pump", {-90, -90});
      },
      {"the pump", "work space was too small", "INFOG(1) = -9", "coarser mesh"});
}

}  // namespace
}  // namespace fretval::fem::sparse_factor_test
