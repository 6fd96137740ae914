#include "fem/stick_zone/stick_zones.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::stick_zones_test {
namespace {

// Parabola, k = 1 in phase: the stick zone ends where the smallest contact does, g(c) = c^2 = d0 - Delta d, and its
// reserve goes on beyond it with a kink. A stick zone that ends inside is read much more closely.
TEST(StickZones, EndingNextToTheSmallestContactAreUncertainByAThousandthOfARing) {
  const int n_rings = 48;
  const auto& normal_problem = normal_half_space(n_rings);
  const auto& tangential_problem = tangential_half_space(n_rings);
  const double mu = 0.5, share = 1e-3 / n_rings;
  Motion motion = one_frequency(0.8, 0.2, 1.5 * mu * 0.2, 0.0);
  const HistoryControl control{72, 400, 1e-6};
  const auto profile = ring_means(normal_problem.compliance, [](double r) { return r * r / 2; });
  const auto normal = normal_history(normal_problem, {}, profile, motion, control);
  const auto zones_of = [&, &tangential = tangential_problem] {
    const auto friction = friction_history(tangential, {}, mu, motion, normal, control);
    return stick_zones(tangential.compliance, normal.cycle, friction, stuck_rings(friction, motion));
  };
  const auto together = zones_of().shakedown;
  EXPECT_GE(together.uncertainty, share);
  EXPECT_NEAR(together.radius, std::sqrt(0.6), together.uncertainty);
  // 0.9 rings inside: the reserve is bent before the kink.
  const double c = std::sqrt(0.6) - 0.9 / n_rings;
  motion.tangential[0].amplitude = 1.5 * mu * (0.8 - c * c);
  const auto next = zones_of().shakedown;
  EXPECT_GE(next.uncertainty, share);
  EXPECT_NEAR(next.radius, c, next.uncertainty);
  motion.tangential[0].amplitude = 1.5 * mu * 0.4;  // A = 0.4: d0 - (0.2 + 0.6)/2
  const auto inside = zones_of().shakedown;
  EXPECT_LT(inside.uncertainty, share);
  EXPECT_NEAR(inside.radius, std::sqrt(0.4), inside.uncertainty);
}

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
    const auto zones =
        stick_zones(tangential_problem.compliance, normal.cycle, friction, stuck_rings(friction, motion));
    EXPECT_NEAR(zones.first_slip.radius, c, zones.first_slip.uncertainty) << n_steps;
    EXPECT_LT(zones.first_slip.uncertainty, 0.2 / n_rings) << n_steps;
    EXPECT_NEAR(zones.shakedown.radius, c, zones.shakedown.uncertainty) << n_steps;
  }
}

// A ring that has lost contact on the way leaves its neighbour's first slip less certain, by 7e-4 rings under a
// parabola, but not what it does in a cycle in which it touches all the time. One that has no grip does not stick.
TEST(StickZones, KnowTheSmallestContactOfTheirOwnTime) {
  const auto& compliance = tangential_half_space(16).compliance;
  const Eigen::Index n = compliance.areas.size();
  const double ring = 1.0 / 16;
  NormalHistory normal;
  normal.pressure = Eigen::MatrixXd::Ones(n, 4);
  normal.smallest_pressure = Eigen::VectorXd::Ones(n);
  FrictionHistory friction;
  friction.first_slip_reserve = friction.shakedown_reserve =
      Eigen::VectorXd::LinSpaced(n, 0.5 - ring / 2, 0.5 - (static_cast<double>(n) - 0.5) * ring);
  friction.slip_path = friction.period_slip = Eigen::VectorXd::Zero(n);
  friction.first_slip_margin = friction.shakedown_margin = friction.first_slip_reserve.cwiseMax(0);
  const auto stuck = stuck_rings(friction, one_frequency(1, 0, 0.1, 0));
  EXPECT_EQ(stuck.first_slip, 8);
  EXPECT_EQ(stuck.shakedown, 8);
  const auto always = stick_zones(compliance, normal, friction, stuck, 2);
  EXPECT_EQ(always.first_slip.uncertainty, always.shakedown.uncertainty);
  normal.smallest_pressure[8] = 0;
  const auto lost = stick_zones(compliance, normal, friction, stuck, 2);
  EXPECT_NEAR(lost.first_slip.uncertainty - always.first_slip.uncertainty, 7e-4 * ring, 1e-12);
  EXPECT_EQ(lost.shakedown.uncertainty, always.shakedown.uncertainty);
}

}  // namespace
}  // namespace fretval::fem::stick_zones_test
