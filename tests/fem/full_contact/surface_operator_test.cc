#include "fem/full_contact/surface_operator.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::surface_operator_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using full_contact_test::response;
using full_contact_test::surface_half_space;

/// The matrix of a linear map of fields with n_rings rows.
template <class Map>
MatrixXd as_matrix(Index n_rings, Index n_columns, const Map& map) {
  const Index n = n_rings * n_columns;
  MatrixXd matrix(n, n);
  for (Index i = 0; i < n; ++i) {
    MatrixXd unit = MatrixXd::Zero(n_rings, n_columns);
    unit.data()[i] = 1;
    const MatrixXd image = map(unit);
    matrix.col(i) = Eigen::Map<const Eigen::VectorXd>(image.data(), n);
  }
  return matrix;
}

MatrixXd image(const SurfaceOperator& op, const MatrixXd& field) {
  MatrixXd result;
  op.apply(field, result);
  return result;
}

void expect_symmetric_positive(const MatrixXd& matrix) {
  EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-14 * matrix.norm());
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues();
  EXPECT_GT(values.minCoeff(), 1e-6 * values.maxCoeff());
}

void expect_symmetric_positive(const SurfaceOperator& op) {
  expect_symmetric_positive(
      as_matrix(op.n_rings(), op.n_columns(), [&](const MatrixXd& field) { return image(op, field); }));
}

// To the highest harmonic that the angles have, also of an even number of them.
TEST(SurfaceOperator, IsSymmetricAndPositiveDefinite) {
  for (const double nu : {0.0, 0.5})
    for (const unsigned n_around : {1U, 4U, 7U, 8U})
      for (const auto field : {SurfaceField::tangential, SurfaceField::normal})
        expect_symmetric_positive({surface_half_space(nu), angular_grid(n_around), field});
  expect_symmetric_positive({surface_half_space(0.3), angular_grid(8, Mirrors::x_and_y), SurfaceField::tangential});
}

TEST(CouplingOperator, KeepsTheWholeSymmetricAndPositiveDefinite) {
  for (const auto& [nu, grid] : {std::make_pair(0.0, angular_grid(7)), std::make_pair(0.3, angular_grid(8)),
                                 std::make_pair(0.3, angular_grid(8, Mirrors::x))}) {
    const auto operators = coupled_operators(surface_half_space(nu), grid);
    expect_symmetric_positive(as_matrix(operators.normal.n_rings(), 3 * grid.n_kept(),
                                        [&](const MatrixXd& fields) { return response(operators, fields); }));
  }
}

// A traction that is the same everywhere on a ring moves the rings, in the mean over the angles, as in the ring
// contact.
TEST(SurfaceOperator, MovesRingsInTheMeanAsTheRingContactDoes) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), SurfaceField::tangential);
  const Eigen::VectorXd on_rings = Eigen::VectorXd::LinSpaced(op.n_rings(), 1, 2);
  MatrixXd traction = MatrixXd::Zero(op.n_rings(), 16), moved;
  traction.leftCols(8) = on_rings.replicate(1, 8);
  op.apply(traction, moved);
  const Eigen::VectorXd expected = *ring_compliance(surface, lateral).matrix * on_rings;
  EXPECT_LT((moved.leftCols(8).rowwise().sum() - expected).norm(), 1e-13 * expected.norm());
  EXPECT_LT(moved.rightCols(8).rowwise().sum().norm(), 1e-13 * expected.norm());
  EXPECT_GT(moved.rightCols(8).norm(), 1e-3 * expected.norm());  // but not at each angle
}

/// Tractions and pressures turned by one angle.
MatrixXd turned(const MatrixXd& fields, Index n) {
  const double angle = 2 * pi / static_cast<double>(n), c = std::cos(angle), s = std::sin(angle);
  MatrixXd result(fields.rows(), fields.cols());
  for (Index j = 0; j < n; ++j) {
    const Index to = (j + 1) % n;
    result.col(to) = c * fields.col(j) - s * fields.col(n + j);
    result.col(n + to) = s * fields.col(j) + c * fields.col(n + j);
    result.col(2 * n + to) = fields.col(2 * n + j);
  }
  return result;
}

// Any field, also a twist: the signs of both parities belong together.
TEST(CouplingOperator, TurnsWithItsFields) {
  const auto operators = coupled_operators(surface_half_space(0.3), angular_grid(7));
  const MatrixXd fields = MatrixXd::Random(operators.normal.n_rings(), 21), moved = response(operators, fields);
  EXPECT_LT((turned(moved, 7) - response(operators, turned(fields, 7))).norm(), 1e-13 * moved.norm());
}

// A quarter of the angles has all of a field that both mirrors leave as it is, half of them what one does.
TEST(SurfaceOperator, IsTheSameOnTheAnglesThatMirrorsKeep) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator whole(surface, angular_grid(8), SurfaceField::tangential);
  const SurfaceOperator quarter(surface, angular_grid(8, Mirrors::x_and_y), SurfaceField::tangential);
  const MatrixXd kept = MatrixXd::Random(whole.n_rings(), 4);
  MatrixXd field(whole.n_rings(), 16), image, image_of_kept;
  field << kept.col(0), kept.col(1), kept.col(1), kept.col(0), kept.col(0), kept.col(1), kept.col(1), kept.col(0),
      kept.col(2), kept.col(3), -kept.col(3), -kept.col(2), kept.col(2), kept.col(3), -kept.col(3), -kept.col(2);
  whole.apply(field, image);
  quarter.apply(kept, image_of_kept);
  EXPECT_LT((4 * image.col(0) - image_of_kept.col(0)).norm(), 1e-13 * image.norm());
  EXPECT_LT((4 * image.col(9) - image_of_kept.col(3)).norm(), 1e-13 * image.norm());
}

TEST(SurfaceOperator, OfTheFirstRingsIsALeadingBlock) {
  const SurfaceOperator op(surface_half_space(0.3), angular_grid(5), SurfaceField::tangential);
  MatrixXd field = MatrixXd::Random(op.n_rings(), op.n_columns());
  field.bottomRows(op.n_rings() - 4).setZero();
  const MatrixXd whole = image(op, field), part = image(op.leading(4), field.topRows(4));
  EXPECT_EQ(op.leading(4).radii(), std::vector<double>(op.radii().begin(), op.radii().begin() + 5));
  EXPECT_LT((whole.topRows(4) - part).norm(), 1e-14 * whole.norm());
}

TEST(CouplingOperator, MovesTheSurfaceTowardsACompressedAxis) {
  const auto operators = coupled_operators(surface_half_space(0.3), angular_grid(4));
  const MatrixXd moved = operators.coupling.along_surface(MatrixXd::Ones(operators.normal.n_rings(), 4));
  EXPECT_LT(moved(3, 0) * std::cos(operators.normal.grid().angles[0]), 0);
}

TEST(CouplingOperator, DoesNothingWhereItIsTold) {
  EXPECT_EQ(CouplingOperator().along_surface(MatrixXd::Ones(3, 4)), MatrixXd::Zero(3, 8));
  EXPECT_EQ(CouplingOperator().into_body(MatrixXd::Ones(3, 8)), MatrixXd::Zero(3, 4));
}

TEST(SurfaceOperator, NeedsTheOrdersThatItsAnglesDrawOn) {
  const auto& surface = surface_half_space(0.5);
  EXPECT_THROW(SurfaceOperator(surface, angular_grid(10), SurfaceField::tangential), std::invalid_argument);
  EXPECT_THROW(CouplingOperator(surface, angular_grid(10)), std::invalid_argument);
}

constexpr double single_precision = 1e-5;

TEST(InverseOperator, UndoesTheOperator) {
  for (const auto kind : {SurfaceField::tangential, SurfaceField::normal}) {
    const SurfaceOperator op(surface_half_space(0.3), angular_grid(7), kind);
    const Eigen::VectorXd ground = Eigen::VectorXd::LinSpaced(op.n_rings(), 0, 3);
    const MatrixXd field = MatrixXd::Random(op.n_rings(), op.n_columns());
    const MatrixXd moved = image(op, field) + ground.cwiseProduct(op.areas()).asDiagonal() * field;
    for (const double unit : {1.0, 1e-60, 1e60}) {  // beyond single precision
      MatrixXd back;
      InverseOperator(op, ground).apply(unit * moved, back);
      EXPECT_LT((back - unit * field).norm(), single_precision * unit * field.norm());
    }
  }
}

TEST(InverseOperator, TakesFieldsOfFewerRings) {
  const SurfaceOperator op(surface_half_space(0.3), angular_grid(8), SurfaceField::tangential);
  const InverseOperator inverse(op, Eigen::VectorXd::Zero(op.n_rings()));
  MatrixXd field = MatrixXd::Random(op.n_rings(), op.n_columns()), whole, part;
  field.bottomRows(3).setZero();
  inverse.apply(field, whole);
  inverse.apply(field.topRows(op.n_rings() - 3), part);
  EXPECT_LT((part - whole.topRows(op.n_rings() - 3)).norm(), single_precision * whole.norm());
}

}  // namespace
}  // namespace fretval::fem::surface_operator_test
