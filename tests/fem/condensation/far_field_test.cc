#include "fem/condensation/far_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/surface_response.h"

namespace fretval::fem::far_field_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of a half-space cut off at a distance.
Compliance half_space_of(const FourierOrder& order, double nu, double far_radius, bool with_far_field,
                         const std::vector<unsigned>& components) {
  auto grid = quarter_disc_grid(1, 16, far_radius, 0.25);
  grid.elasticity.poisson_ratio = nu;
  const HarmonicSpace space(grid, order, 3);
  const auto line = space.contact_line(components);
  const Condensation condensation(assemble_skeleton_stiffness(space), line.dofs, "half-space");
  auto compliance = contact_compliance(line, condensation.schur_complement());
  if (with_far_field) add_far_field(space, condensation, components, compliance);
  return compliance;
}

/// Of a uniform traction on the whole line, by its exact value. It is uniform but for the rings of the last few
/// percent, so that finite elements show the far field: 2e-5 without one.
double error_of_disc(const FourierOrder& order, double nu, double far_radius, bool with_far_field) {
  const double per_k = order == axisymmetric ? 1 - nu : (2 - nu) / 2;
  const auto compliance = half_space_of(order, nu, far_radius, with_far_field, {ring_component(order)});
  return compliance.matrix->sum() / disc_response([](double) { return 0.0; }, per_k, 1, infinite) - 1;
}

// Without it a body cut off at R is off by a/R, with it by the third power of that.
TEST(FarField, MakesACompressibleHalfSpaceExactForTheForce) {
  for (const auto& order : {axisymmetric, lateral})
    for (const double nu : {0.0, 0.3, 0.45}) {
      EXPECT_GT(std::abs(error_of_disc(order, nu, 6, false)), (1 - 2 * nu) * 5e-3) << order.n << " " << nu;
      EXPECT_LT(std::abs(error_of_disc(order, nu, 6, true)), 2e-3) << order.n << " " << nu;
      EXPECT_LT(std::abs(error_of_disc(order, nu, 24, true)), 5e-5) << order.n << " " << nu;
    }
}

TEST(FarField, LeavesAnIncompressibleBodyAsItIs) {
  for (const auto& order : {axisymmetric, lateral})
    EXPECT_EQ(error_of_disc(order, 0.5, 6, true), error_of_disc(order, 0.5, 6, false));
}

// The residual of nu = 1/2 vanishes: the point force meets the condition.
TEST(FarField, LacksNothingWhereTheBodyIsIncompressible) {
  for (const auto& order : {axisymmetric, lateral}) {
    auto grid = quarter_disc_grid(1, 8, 6, 0.35);
    const double incompressible = far_residual(HarmonicSpace(grid, order, 2)).norm();
    grid.elasticity.poisson_ratio = 0.3;
    const HarmonicSpace space(grid, order, 2);
    EXPECT_LT(incompressible, 1e-2 * far_residual(space).norm());
    EXPECT_TRUE(lacks_far_field(space));
    EXPECT_FALSE(lacks_far_field(HarmonicSpace(grid, {2, Parity::even}, 2)));
  }
}

// A uniform pressure p on a disc moves the surface inside towards the axis, u_r = -(1 - 2 nu) p r/4; a unit traction on
// W points upwards. Rings next to the edge, where u_r has a kink, are left out: 1e-3.
TEST(FarField, OfSeveralComponentsCouplesThem) {
  const double nu = 0.3;
  const auto compliance = half_space_of(axisymmetric, nu, 24, true, {1, 0});
  const Eigen::Index n = compliance.areas.size();
  const Eigen::VectorXd radial = compliance.matrix->bottomLeftCorner(n, n).rowwise().sum();
  for (Eigen::Index i = 1; i < n - 3; ++i) {
    const double r0 = compliance.radii[i], r1 = compliance.radii[i + 1];
    const double exact = (1 - 2 * nu) / 4 * 2 * pi * (std::pow(r1, 3) - std::pow(r0, 3)) / 3;
    EXPECT_NEAR(radial[i] / exact, 1, 5e-3) << i;
  }
  EXPECT_LT((*compliance.matrix - compliance.matrix->transpose()).norm(), 1e-14 * compliance.matrix->norm());
}

}  // namespace
}  // namespace fretval::fem::far_field_test
