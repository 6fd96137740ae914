#include "fem/full_contact/projected_gradients.h"

#include <gtest/gtest.h>

#include "fem/full_contact/surface_history.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::projected_gradients_test {
namespace {

using Eigen::MatrixXd;
using full_contact_test::nowhere;
using full_contact_test::ramp;
using full_contact_test::round_profile;
using full_contact_test::surface_half_space;

// K is symmetric, so that the Rayleigh quotient of no field exceeds its largest eigenvalue.
TEST(ProjectedGradients, StepByTheLargestEigenvalue) {
  const SurfaceOperator op(surface_half_space(0.5), angular_grid(4), SurfaceField::tangential);
  const double largest = largest_eigenvalue(op);
  MatrixXd field = MatrixXd::Ones(op.n_rings(), op.n_columns()), image;
  for (int k = 0; k < 3; ++k) {
    op.apply(field, image);
    const double quotient = image.cwiseProduct(field).sum() / field.squaredNorm();
    EXPECT_LT(quotient, largest);
    field = image;
  }
  EXPECT_GT(image.cwiseProduct(image).sum(), 0);
  op.apply(field, image);
  EXPECT_GT(image.cwiseProduct(field).sum() / field.squaredNorm(), 0.9 * largest);
}

TEST(ProjectedGradients, ConfirmACoupledContactAndNoticeAWrongOne) {
  const auto& surface = surface_half_space(0.3);
  const auto operators = coupled_operators(surface, angular_grid(4, Mirrors::x));
  const IndenterMotion motion{ramp(0.4, 0.6), {ramp(0, 0.15), nowhere}};
  CoupledContact contact(operators, {}, 0.5, round_profile(surface, 2, operators.normal.grid().n_kept()), motion, 4);
  SecondAlgorithm second;
  for (int k = 0; k < 4; ++k) {
    contact.step();
    second.see(contact);
  }
  EXPECT_GT(contact.pressure.maxCoeff(), 0.1);
  EXPECT_LT(second.difference(), 1e-7);
  contact.friction.limit *= 1.01;
  second.see(contact);
  EXPECT_GT(second.difference(), 1e-3) << "what slips could bear more than it does";
}

}  // namespace
}  // namespace fretval::fem::projected_gradients_test
