#include "fem/full_contact/surface_operator.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::surface_operator_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using full_contact_test::surface_half_space;

MatrixXd as_matrix(const SurfaceOperator& op) {
  const Index n = op.n_rings() * op.n_columns();
  MatrixXd matrix(n, n), image;
  for (Index i = 0; i < n; ++i) {
    MatrixXd unit = MatrixXd::Zero(op.n_rings(), op.n_columns());
    unit.data()[i] = 1;
    op.apply(unit, image);
    matrix.col(i) = Eigen::Map<const Eigen::VectorXd>(image.data(), n);
  }
  return matrix;
}

void expect_symmetric_positive(const SurfaceOperator& op) {
  const auto matrix = as_matrix(op);
  EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-14 * matrix.norm());
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(matrix).eigenvalues();
  EXPECT_GT(values.minCoeff(), 1e-6 * values.maxCoeff());
}

// To the highest harmonic that the angles have, also of an even number of them.
TEST(SurfaceOperator, IsSymmetricAndPositiveDefinite) {
  for (const double nu : {0.0, 0.5})
    for (const unsigned n_around : {1U, 4U, 7U, 8U})
      for (const auto fields : {Fields::tangential, Fields::normal, Fields::all})
        for (const bool coupling : {false, true})
          expect_symmetric_positive({surface_half_space(nu), angular_grid(n_around), fields, coupling});
  expect_symmetric_positive({surface_half_space(0.3), angular_grid(8, Mirrors::x), Fields::all});
  expect_symmetric_positive({surface_half_space(0.3), angular_grid(8, Mirrors::x_and_y), Fields::tangential});
}

// A traction that is the same everywhere on a ring moves the rings, in the mean over the angles, as in the ring
// contact.
TEST(SurfaceOperator, MovesRingsInTheMeanAsTheRingContactDoes) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator op(surface, angular_grid(8), Fields::tangential);
  const Eigen::VectorXd on_rings = Eigen::VectorXd::LinSpaced(op.n_rings(), 1, 2);
  MatrixXd traction = MatrixXd::Zero(op.n_rings(), 16), moved;
  traction.leftCols(8) = on_rings.replicate(1, 8);
  op.apply(traction, moved);
  const Eigen::VectorXd expected = *ring_compliance(surface, lateral).matrix * on_rings;
  EXPECT_LT((moved.leftCols(8).rowwise().sum() - expected).norm(), 1e-13 * expected.norm());
  EXPECT_LT(moved.rightCols(8).rowwise().sum().norm(), 1e-13 * expected.norm());
  EXPECT_GT(moved.rightCols(8).norm(), 1e-3 * expected.norm());  // but not at each angle
}

/// A field turned by one angle.
MatrixXd turned(const MatrixXd& field, Index n, bool has_pressure) {
  const double angle = 2 * pi / static_cast<double>(n), c = std::cos(angle), s = std::sin(angle);
  MatrixXd result(field.rows(), field.cols());
  for (Index j = 0; j < n; ++j) {
    const Index to = (j + 1) % n;
    result.col(to) = c * field.col(j) - s * field.col(n + j);
    result.col(n + to) = s * field.col(j) + c * field.col(n + j);
    if (has_pressure) result.col(2 * n + to) = field.col(2 * n + j);
  }
  return result;
}

// Any field, also a twist: the signs of both parities belong together.
TEST(SurfaceOperator, TurnsWithItsFields) {
  const SurfaceOperator op(surface_half_space(0.3), angular_grid(7), Fields::all);
  const MatrixXd field = MatrixXd::Random(op.n_rings(), op.n_columns());
  MatrixXd image, image_of_turned;
  op.apply(field, image);
  op.apply(turned(field, 7, true), image_of_turned);
  EXPECT_LT((turned(image, 7, true) - image_of_turned).norm(), 1e-13 * image.norm());
}

// A quarter of the angles has all of a field that both mirrors leave as it is, half of them what one does.
TEST(SurfaceOperator, IsTheSameOnTheAnglesThatMirrorsKeep) {
  const auto& surface = surface_half_space(0.5);
  const SurfaceOperator whole(surface, angular_grid(8), Fields::tangential);
  const SurfaceOperator quarter(surface, angular_grid(8, Mirrors::x_and_y), Fields::tangential);
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
  const SurfaceOperator op(surface_half_space(0.3), angular_grid(5), Fields::all);
  MatrixXd field = MatrixXd::Random(op.n_rings(), op.n_columns()), image, image_of_part;
  field.bottomRows(op.n_rings() - 4).setZero();
  op.apply(field, image);
  op.leading(4).apply(field.topRows(4), image_of_part);
  EXPECT_EQ(op.leading(4).radii(), std::vector<double>(op.radii().begin(), op.radii().begin() + 5));
  EXPECT_LT((image.topRows(4) - image_of_part).norm(), 1e-14 * image.norm());
}

TEST(SurfaceOperator, CouplesPressureAndTractionUnlessItIsTold) {
  const auto& surface = surface_half_space(0.3);
  for (const bool coupling : {false, true}) {
    const SurfaceOperator op(surface, angular_grid(4), Fields::all, coupling);
    MatrixXd pressure = MatrixXd::Zero(op.n_rings(), 12), moved;
    pressure.rightCols(4).setOnes();
    op.apply(pressure, moved);
    EXPECT_EQ(moved.leftCols(8).norm() > 1e-3 * moved.norm(), coupling);
    // Towards the axis, as a compressible body does under a pressure.
    if (coupling) {
      EXPECT_LT(moved(3, 0) * std::cos(op.grid().angles[0]), 0);
    }
  }
}

TEST(SurfaceOperator, NeedsTheOrdersThatItsAnglesDrawOn) {
  EXPECT_THROW(SurfaceOperator(surface_half_space(0.5), angular_grid(10), Fields::all), std::invalid_argument);
}

TEST(InverseOperator, UndoesTheOperator) {
  for (const auto fields : {Fields::tangential, Fields::normal, Fields::all}) {
    const SurfaceOperator op(surface_half_space(0.3), angular_grid(7), fields);
    const Eigen::VectorXd ground = Eigen::VectorXd::LinSpaced(op.n_rings(), 0, 3);
    const MatrixXd field = MatrixXd::Random(op.n_rings(), op.n_columns());
    MatrixXd image, back;
    op.apply(field, image);
    image += ground.cwiseProduct(op.areas()).asDiagonal() * field;
    InverseOperator(op, ground).apply(image, back);
    EXPECT_LT((back - field).norm(), 1e-10 * field.norm());
  }
}

}  // namespace
}  // namespace fretval::fem::surface_operator_test
