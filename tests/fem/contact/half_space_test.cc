#include "fem/contact/half_space.h"

#include <gtest/gtest.h>

#include "fem/condensation/compliance.h"
#include "fem/condensation/condensation.h"
#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::half_space_formulas_test {
namespace {

/// Of a unit disc under a unit traction, by finite elements.
double mean_displacement(const FourierOrder& order, double poisson_ratio) {
  constexpr unsigned n_rings = 16;
  constexpr double far_radius = 40;
  auto grid = quarter_disc_grid(1, n_rings, far_radius, 0.3);
  grid.elasticity.poisson_ratio = poisson_ratio;
  const HarmonicSpace space(grid, order, 3);
  const Condensation condensation(assemble_stiffness(space), space.contact_line().dofs, "body");
  const auto compliance = contact_compliance(space.contact_line(), condensation.schur_complement());
  return compliance.matrix->sum() / pi;
}

// A uniform traction moves its disc by 32/(3 pi k) on average, k the force of the punch over its radius.
TEST(HalfSpace, HasThePunchesOfItsOperators) {
  for (const double nu : {0.2, 0.5}) {
    EXPECT_NEAR(mean_displacement(axisymmetric, nu) * normal_punch(nu) * 3 * pi / 32, 1, 1e-2) << nu;
    EXPECT_NEAR(mean_displacement(lateral, nu) * tangential_punch(nu) * 3 * pi / 32, 1, 1e-2) << nu;
  }
}

TEST(HalfSpace, RatioIsThatOfThePunches) {
  for (const double nu : {0.0, 0.3, 0.5})
    EXPECT_DOUBLE_EQ(normal_over_tangential_punch(nu), normal_punch(nu) / tangential_punch(nu));
}

}  // namespace
}  // namespace fretval::fem::half_space_formulas_test
