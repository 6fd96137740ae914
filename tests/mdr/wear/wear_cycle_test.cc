#include "mdr/wear/wear_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/stick/stick_radius.h"
#include "tests/mdr/measured_cycle.h"

namespace fretval::mdr::wear_cycle_test {
namespace {

const double mu = 0.6;
const Profile sphere = parabola(1);

// mu int p |ds| dA over the friction work of the springs, less 1.
double reye_error(const PronyBody& body, const Motion& motion, Eigen::Index n, int steps) {
  const MeasuredCycle m = measured_cycle(body, motion, n, steps);
  return mu * body.relaxed_modulus * (m.matrices.area * pressure_path(m)).sum() / m.cycle.friction_work - 1;
}

// Surface and springs do the same work. What remains is the trapezoidal rule over steps in which slip sets in while the
// load changes: none at constant indentation, else of second order in the step.
TEST(WearCycle, WornVolumeIsFrictionWork) {
  const Motion tangential{1, 0, 0.3, 1, 1, M_PI / 2}, both{1, 0.15, 0.3, 1, 1, 0.7};
  for (const PronyBody& body : {elastic(2), standard_solid(2, 2, 0.1)}) {
    EXPECT_NEAR(reye_error(body, tangential, 100, 45), 0, 1e-12);  // roundoff
    const double coarse = reye_error(body, both, 100, 45), fine = reye_error(body, both, 100, 360);
    EXPECT_LT(std::abs(coarse), 0.003);
    EXPECT_LT(std::abs(fine), std::abs(coarse) / 30);  // 64 but for the few steps in which slip turns round
  }
}

TEST(WearCycle, RadiiAreThoseOfTheory) {
  const Motion motion{1, 0.15, 0.15, 1, 1, 0.7};
  const PronyBody body = standard_solid(1, 1, 0.1);
  const MeasuredCycle m = measured_cycle(body, motion, 200, 90);
  EXPECT_NEAR(m.cycle.contact_radius, std::sqrt(1.15), 1.6 / 200);  // half a spring, and its mean depth
  EXPECT_NEAR(m.cycle.stick_radius, *stick_radii(sphere, body, mu, motion).shakedown, 1.6 / 200);
  EXPECT_GT(m.cycle.friction_work, 0);
}

}  // namespace
}  // namespace fretval::mdr::wear_cycle_test
