#include "fem/ring_contact/stick_zone/stick_zones.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::stick_zones_test {
namespace {

// r^4, elastic, phi = 90 deg, g(c) = c^4 = d0 - sqrt(A^2 + Delta d^2) = 1e-4. The margins of the outer rings of such a
// zone have kinks: a parabola through their samples touches zero, and the zone was lost at 60, 71 and 72 steps a cycle.
TEST(StickZones, AreThereWhateverTheSteps) {
  const int n_rings = 48;
  const auto& normal_problem = normal_half_space(n_rings);
  const auto& tangential_problem = tangential_half_space(n_rings);
  const double mu = 0.3, c = 0.1, mean = 1 / 1.1, amplitude = 0.1 / 1.1;
  const double slope = std::sqrt(std::pow(mean - std::pow(c, 4), 2) - amplitude * amplitude);
  Motion motion = one_frequency(mean, amplitude, 1.5 * mu * slope, pi / 2);
  motion.n_ramp_cycles = 1;
  const auto profile = ring_means(normal_problem.compliance, [](double r) { return 3.0 / 8 * std::pow(r, 4); });
  for (const int n_steps : {36, 60, 71, 72, 90}) {
    const HistoryControl control{n_steps, 400, 1e-6};
    const auto normal = normal_history(normal_problem, {}, profile, motion, control);
    const auto friction = friction_history(tangential_problem, {}, mu, motion, normal, control);
    const auto zones = stick_zones(tangential_problem.compliance, friction, stuck_rings(friction, motion));
    EXPECT_NEAR(zones.first_slip.radius, c, zones.first_slip.uncertainty) << n_steps;
    EXPECT_LT(zones.first_slip.uncertainty, 0.2 / n_rings) << n_steps;
    EXPECT_NEAR(zones.shakedown.radius, c, zones.shakedown.uncertainty) << n_steps;
  }
}

// A ring that is without a load at an instant has nothing to hold it, even if it did not slip; nor has one beyond.
TEST(StickZones, EndWhereARingHasNoGrip) {
  FrictionHistory friction{};
  friction.amplitude = 1;
  friction.slip_path = friction.period_slip = Eigen::Vector4d::Zero();
  friction.first_slip_margin = Eigen::Vector4d(1, 0, 1, 1);
  friction.shakedown_margin = Eigen::Vector4d(1, 1, 0, 1);
  const auto stuck = stuck_rings(friction, one_frequency(1, 0.1, 1, 0.0));
  EXPECT_EQ(stuck.first_slip, 1);
  EXPECT_EQ(stuck.shakedown, 2);
}

}  // namespace
}  // namespace fretval::fem::stick_zones_test
