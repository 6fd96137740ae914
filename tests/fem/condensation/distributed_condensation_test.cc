#include "fem/condensation/distributed_condensation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space.h"
#include "fem/operators/stiffness.h"
#include "fem/support/processes.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/half_space.h"
#include "tests/fem/saddle_point.h"

// By one process here, and by two and three in the tests fem.ranks of ctest.
namespace fretval::fem::distributed_condensation_test {
namespace {

Share own_share() {
  const auto process = this_process();
  return {static_cast<unsigned>(process.number), static_cast<unsigned>(process.count)};
}

/// The entries of a matrix that this process has: some whole, those of the first row in parts that add up.
SparseMatrix share_of(const Eigen::MatrixXd& matrix) {
  auto share = rows_of(matrix);
  const auto [number, count] = own_share();
  for (int row = 0; row < share.n; ++row)
    for (int k = share.row_start[row]; k < share.row_start[row + 1]; ++k)
      if (row == 0)
        share.values[k] /= count;
      else if (static_cast<unsigned>(share.columns[k] + row) % count != number)
        share.values[k] = 0;
  return share;
}

/// Of the first process; the others have to have nothing.
void expect_near(const Eigen::MatrixXd& schur, const Eigen::MatrixXd& expected, double tolerance) {
  if (own_share().number > 0) {
    EXPECT_EQ(schur.size(), 0);
    return;
  }
  ASSERT_EQ(schur.rows(), expected.rows());
  EXPECT_EQ(schur, schur.transpose());
  EXPECT_LT((schur - expected).cwiseAbs().maxCoeff(), tolerance * expected.cwiseAbs().maxCoeff());
}

TEST(DistributedCondensation, IsThatOfASumOfShares) {
  const Eigen::MatrixXd matrix = small_saddle_point();
  const std::vector<unsigned> kept{4, 1, 2};
  expect_near(distributed_schur_complement(share_of(matrix), kept, "small"),
              Condensation(rows_of(matrix), kept, "small").schur_complement(), 1e-12);
}

class DistributedCondensationOf : public testing::TestWithParam<std::tuple<FourierOrder, unsigned>> {};

INSTANTIATE_TEST_SUITE_P(HarmonicsAndDegrees, DistributedCondensationOf,
                         testing::Combine(testing::Values(axisymmetric, lateral), testing::Values(2U, 3U)));

// Another ordering, other sums: roundoff, 1e-12 measured.
TEST_P(DistributedCondensationOf, ABodyIsThatOfOneProcess) {
  const HarmonicSpace space(quarter_disc_grid(1, 16, 20, 0.25), std::get<0>(GetParam()), std::get<1>(GetParam()));
  const auto& dofs = space.contact_line().dofs;
  const Condensation alone(assemble_skeleton_stiffness(space), dofs, "body");
  expect_near(distributed_schur_complement(assemble_skeleton_stiffness(space, own_share()), dofs, "body"),
              alone.schur_complement(), 1e-10);
}

TEST(DistributedCondensation, GivesMumpsMoreMemoryOnce) {
  Eigen::MatrixXd matrix = random_symmetric(600, 3);
  matrix.diagonal().head(3).setConstant(1e4);  // S is positive definite
  const std::vector<unsigned> kept{0, 1, 2};
  const auto share = share_of(matrix);
  expect_near(distributed_schur_complement(share, kept, "the pump", {-90, 60}),
              Condensation(rows_of(matrix), kept, "the pump").schur_complement(), 1e-9);
  expect_solver_error(
      [&] {
        distributed_schur_complement(share, kept, "the pump", {-90, -90});
      },
      {"the pump", "the factorisation", "work space was too small"});
}

// All processes say the same: none waits for another one.
TEST(DistributedCondensation, SaysSingular) {
  Eigen::MatrixXd matrix = small_saddle_point();
  matrix.row(5) = matrix.row(3);
  matrix.col(5) = matrix.col(3);
  expect_solver_error([&] { distributed_schur_complement(share_of(matrix), {1}, "the pump"); },
                      {"the pump", "singular"});
  expect_solver_error(
      [&] {
        distributed_schur_complement(share_of(matrix), {3, 5}, "the pump");
      },
      {"the pump", "singular"});
  matrix = small_saddle_point();
  matrix(2, 4) = std::nan("");
  expect_solver_error([&] { distributed_schur_complement(share_of(matrix), {1}, "the pump"); }, {"the pump"});
}

}  // namespace
}  // namespace fretval::fem::distributed_condensation_test
