#include "fem/full_contact/surface_compliance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/condensation/condensation.h"
#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"
#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::surface_compliance_test {
namespace {

using full_contact_test::surface_half_space;

TEST(SurfaceCompliance, HasTheComplianceOfTheRingContact) {
  const auto& surface = surface_half_space(0.5);
  for (const auto& order : {axisymmetric, lateral}) {
    const HarmonicSpace space(quarter_disc_grid(1.125, 9, 25, 0.25), order, 3);
    const Condensation condensation(assemble_skeleton_stiffness(space), space.contact_line().dofs, "half-space");
    const auto one = contact_compliance(space.contact_line(), condensation.schur_complement());
    const auto of_all = ring_compliance(surface, order);
    EXPECT_LT((*of_all.matrix - *one.matrix).norm(), 1e-10 * one.matrix->norm()) << order.n;
    EXPECT_EQ(of_all.radii, one.radii);
  }
}

// Of nu = 0 the responses along and across a wave are equal, so s and m of a Cartesian harmonic are as well: m of order
// l - 1 and s of l + 1, without coupling between them. Eight rings: 1e-3.
TEST(SurfaceCompliance, OfAHalfSpaceWithoutPoissonsEffectHasOneResponseToATractionInAnyDirection) {
  const auto& surface = surface_half_space(0);
  const Eigen::Index n = surface.n_rings();
  for (unsigned l = 2; l <= 4; ++l) {
    const Eigen::MatrixXd m = surface.orders[l - 1]->block(n, n, n, n), s = surface.orders[l + 1]->topLeftCorner(n, n);
    EXPECT_LT((m - s).norm(), 3e-3 * s.norm()) << l;
    EXPECT_LT(surface.orders[l]->block(0, n, n, n).norm(), 3e-3 * s.norm()) << l;
  }
  const auto& incompressible = surface_half_space(0.5);
  EXPECT_GT(incompressible.orders[2]->block(0, n, n, n).norm(),
            0.1 * incompressible.orders[2]->block(0, 0, n, n).norm());
}

// A disc that sticks to a half-space: F = 4 G a d ln(3 - 4 nu)/(1 - 2 nu) (Johnson, Contact Mechanics, 3.35). The
// pressure oscillates next to the edge, where rings resolve nothing of it: the first order of the rings.
TEST(SurfaceCompliance, MakesABondedPunchAsStiffAsItIs) {
  const double nu = 0.3, exact = 4 * std::log(3 - 4 * nu) / (1 - 2 * nu);
  std::vector<double> errors;
  for (const unsigned n_per_radius : {8U, 16U}) {
    const auto& surface = surface_half_space(nu, n_per_radius);
    const Eigen::Index n = surface.n_rings(), inside = n_per_radius;
    Eigen::MatrixXd block(2 * inside, 2 * inside);
    for (Eigen::Index i = 0; i < 2; ++i)
      for (Eigen::Index j = 0; j < 2; ++j)
        block.block(i * inside, j * inside, inside, inside) = surface.orders[0]->block(i * n, j * n, inside, inside);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * inside);
    right.tail(inside) = surface.areas.head(inside);
    errors.push_back(right.dot(block.llt().solve(right)) / exact - 1);
  }
  EXPECT_NEAR(errors[1], errors[0] / 2, 0.1 * std::abs(errors[0]));
  EXPECT_NEAR(2 * errors[1] - errors[0], 0, 1e-3);  // extrapolated
}

// A disc that turns on a half-space: the torque is 16/3 G a^3 per angle (Reissner and Sagoci 1944). The traction is
// singular at the edge, where rings are of first order.
TEST(SurfaceCompliance, MakesATurningDiscAsStiffAsItIs) {
  std::vector<double> errors;
  for (const unsigned n_per_radius : {8U, 16U}) {
    const auto& surface = surface_half_space(0.5, n_per_radius);
    const Eigen::Index n = n_per_radius;
    Eigen::VectorXd moved(n);  // integral of r over each ring
    for (std::size_t i = 0; i < n_per_radius; ++i)
      moved[static_cast<Eigen::Index>(i)] =
          2 * pi / 3 * (std::pow(surface.radii[i + 1], 3) - std::pow(surface.radii[i], 3));
    const Eigen::MatrixXd block = surface.torsion->topLeftCorner(n, n);
    errors.push_back(moved.dot(block.llt().solve(moved)) / (16.0 / 3) - 1);
  }
  EXPECT_NEAR(errors[1], errors[0] / 2, 0.1 * std::abs(errors[0]));
  EXPECT_NEAR(2 * errors[1] - errors[0], 0, 5e-3);  // extrapolated
}

}  // namespace
}  // namespace fretval::fem::surface_compliance_test
