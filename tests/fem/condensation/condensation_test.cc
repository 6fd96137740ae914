#include "fem/condensation/condensation.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <tuple>

#include "fem/operators/harmonic_space.h"
#include "fem/operators/stiffness.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/half_space.h"
#include "tests/fem/random_vector.h"
#include "tests/fem/saddle_point.h"

namespace fretval::fem::condensation_test {
namespace {

const GridData& grid() {
  static const GridData grid = quarter_disc_grid(1, 16, 20, 0.25);
  return grid;
}

TEST(Condensation, IsTheSchurComplementOfADenseMatrix) {
  const Eigen::MatrixXd matrix = small_saddle_point();
  const std::vector<unsigned> kept{4, 1, 2};  // any order
  const std::vector<int> eliminated{0, 3, 5, 6, 7};
  Eigen::MatrixXd cc(3, 3), ci(3, 5), ii(5, 5);
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) cc(a, b) = matrix(kept[a], kept[b]);
    for (int b = 0; b < 5; ++b) ci(a, b) = matrix(kept[a], eliminated[b]);
  }
  for (int a = 0; a < 5; ++a)
    for (int b = 0; b < 5; ++b) ii(a, b) = matrix(eliminated[a], eliminated[b]);
  const Eigen::MatrixXd expected = cc - ci * ii.partialPivLu().solve(ci.transpose());
  const Condensation condensation(rows_of(matrix), kept, "small");
  EXPECT_LT((condensation.schur_complement() - expected).norm(), 1e-12 * expected.norm());
  const Eigen::VectorXd rhs = random_vector(8, 2);
  EXPECT_LT((condensation.solve(rhs) - matrix.partialPivLu().solve(rhs)).norm(), 1e-13);
}

class CondensationOf : public testing::TestWithParam<FourierOrder> {
 protected:
  HarmonicSpace space_{grid(), GetParam(), 3};
  SparseMatrix stiffness_ = assemble_stiffness(space_);
  Condensation condensation_{stiffness_, space_.contact_line().dofs, "body"};
};

INSTANTIATE_TEST_SUITE_P(Harmonics, CondensationOf, testing::Values(axisymmetric, lateral));

TEST_P(CondensationOf, ABodyIsSymmetricPositiveDefinite) {
  const Eigen::MatrixXd& schur = condensation_.schur_complement();
  EXPECT_EQ(schur, schur.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(schur);
  EXPECT_GT(eigen.eigenvalues()[0], 0);
}

// Two direct solves of the same system: 2e-13 measured.
TEST_P(CondensationOf, ABodyGivesTheSolutionOfTheWholeSystem) {
  const auto& line = space_.contact_line();
  Eigen::VectorXd surface_load = Eigen::VectorXd::Zero(stiffness_.n);
  for (std::size_t i = 0; i < line.dofs.size(); ++i) surface_load[line.dofs[i]] = line.loads.row(i).sum();
  for (const Eigen::VectorXd& rhs : {surface_load, random_vector(stiffness_.n, 2)}) {
    const Eigen::VectorXd whole = solve_uncondensed(stiffness_, rhs, "body");
    const double difference = (condensation_.solve(rhs) - whole).norm() / whole.norm();
    EXPECT_LT(difference, 1e-10);
  }
}

// S maps contact displacements to contact forces, so S u_c = loads for the whole solution u.
TEST_P(CondensationOf, ABodyKeepsTheContactForces) {
  const auto& line = space_.contact_line();
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(stiffness_.n);
  const Eigen::VectorXd load = line.loads.col(3);
  for (std::size_t i = 0; i < line.dofs.size(); ++i) rhs[line.dofs[i]] = load[static_cast<Eigen::Index>(i)];
  const Eigen::VectorXd whole = solve_uncondensed(stiffness_, rhs, "body");
  Eigen::VectorXd on_line(load.size());
  for (std::size_t i = 0; i < line.dofs.size(); ++i) on_line[static_cast<Eigen::Index>(i)] = whole[line.dofs[i]];
  EXPECT_LT((condensation_.schur_complement() * on_line - load).norm(), 1e-10 * load.norm());
}

/// Harmonic and degree.
class CondensationOfASkeleton : public testing::TestWithParam<std::tuple<FourierOrder, unsigned>> {};

INSTANTIATE_TEST_SUITE_P(HarmonicsAndDegrees, CondensationOfASkeleton,
                         testing::Combine(testing::Values(axisymmetric, lateral), testing::Values(2U, 3U, 4U)));

// What is inside cells is eliminated before or by MUMPS: roundoff, 1e-13 measured.
TEST_P(CondensationOfASkeleton, IsThatOfTheWholeBody) {
  const HarmonicSpace space(quarter_disc_grid(1, 8, 6, 0.35), std::get<0>(GetParam()), std::get<1>(GetParam()));
  const auto& line = space.contact_line();
  const SparseMatrix stiffness = assemble_stiffness(space);
  const Condensation whole(stiffness, line.dofs, "body");
  const Condensation skeleton(assemble_skeleton_stiffness(space), line.dofs, "skeleton");
  const Eigen::MatrixXd difference = skeleton.schur_complement() - whole.schur_complement();
  EXPECT_LT(difference.cwiseAbs().maxCoeff(), 1e-10 * whole.schur_complement().cwiseAbs().maxCoeff());

  Eigen::VectorXd load = Eigen::VectorXd::Zero(space.n_dofs());
  for (std::size_t i = 0; i < line.dofs.size(); ++i) load[line.dofs[i]] = line.loads(static_cast<Eigen::Index>(i), 3);
  const Eigen::VectorXd field = extend_into_cells(space, skeleton.solve(load.head(space.n_skeleton_dofs())));
  EXPECT_LT((multiply(stiffness, field) - load).norm(), 1e-9 * load.norm());
  const Eigen::VectorXd expected = whole.solve(load);
  EXPECT_LT((field - expected).norm(), 1e-10 * expected.norm());
}

TEST(CondensationErrors, NameTheEntryThatIsNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Eigen::MatrixXd matrix = small_saddle_point();
    matrix(2, 5) = bad;
    expect_solver_error([&] { Condensation(rows_of(matrix), {1}, "the pump"); },
                        {"the pump", "row 2", "column 5", "not finite"});
    expect_solver_error([&] { solve_uncondensed(rows_of(matrix), random_vector(8, 2), "the pump"); },
                        {"the pump", "row 2", "column 5", "not finite"});
  }
}

TEST(CondensationErrors, NameTheEmptyRow) {
  Eigen::MatrixXd matrix = small_saddle_point();
  matrix.row(3).setZero();
  matrix.col(3).setZero();
  expect_solver_error([&] { Condensation(rows_of(matrix), {1}, "the pump"); }, {"the pump", "row 3", "empty"});
}

TEST(CondensationErrors, SaySingular) {
  Eigen::MatrixXd matrix = small_saddle_point();
  matrix.row(5) = matrix.row(3);
  matrix.col(5) = matrix.col(3);  // two equal unknowns, none of them kept
  expect_solver_error([&] { Condensation(rows_of(matrix), {1}, "the pump"); }, {"the pump", "singular"});
  expect_solver_error([&] { solve_uncondensed(rows_of(matrix), random_vector(8, 2), "the pump"); },
                      {"the pump", "singular"});
}

// Here the eliminated part is regular; only the solve of the probe meets the zero pivot.
TEST(CondensationErrors, NoticeASingularSchurComplement) {
  Eigen::MatrixXd matrix = small_saddle_point();
  matrix.row(5) = matrix.row(3);
  matrix.col(5) = matrix.col(3);
  expect_solver_error([&] { Condensation(rows_of(matrix), {3, 5}, "the pump"); }, {"the pump", "singular"});
}

}  // namespace
}  // namespace fretval::fem::condensation_test
