#include "fem/history/friction_search.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/history/friction_history.h"
#include "fem/ring_contact/stick_zone/stick_radius.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::friction_search_test {
namespace {

constexpr double mu = 0.5;
constexpr unsigned n_per_radius = 32;

/// A body that creeps for 3.8 periods, in which plain periods come to the periodic state as well.
RelaxationModel creeping() {
  return {1, {3}, {6}, 0};
}

Motion oblique(const RelaxationModel& model) {
  const double rho = std::abs(stiffening_at(model, 1));
  Motion motion = one_frequency(0.8, 0.3 / rho, 1.5 * mu * 0.4 / rho, pi / 3);
  motion.n_ramp_cycles = 4;
  return motion;
}

struct Case {
  RelaxationModel model;
  Motion motion = oblique(model);
  Eigen::VectorXd profile = parabola_means(normal_half_space(n_per_radius));

  [[nodiscard]] NormalContact normal(int n_steps) const {
    return {normal_half_space(n_per_radius), model, profile, motion, n_steps};
  }
  [[nodiscard]] WatchedFriction friction(int n_steps) const {
    return {tangential_half_space(n_per_radius), model, mu, motion, n_steps};
  }
};

double radius_of(const Eigen::VectorXd& reserve, Eigen::Index n_stuck) {
  return stick_radius(tangential_half_space(n_per_radius).compliance, reserve, n_stuck).radius;
}

// Against 150 plain periods, after which 1e-17 of the start is left.
TEST(FrictionSearch, EndsWherePlainPeriodsLeadTo) {
  const Case moderate{creeping()};
  constexpr int n_steps = 36;
  auto normal = moderate.normal(n_steps);
  auto friction = moderate.friction(n_steps);
  while (normal.n_steps < 150L * n_steps) {
    normal.step();
    friction.step_beside(normal);
  }
  FrictionHistory plain;
  friction.first_slip.report(plain);
  friction.period.hand_over(tangential_half_space(n_per_radius), plain);

  const auto direct = contact_history(moderate.normal(n_steps), moderate.friction(n_steps), {n_steps, 100, 1e-6});
  EXPECT_GT(direct.normal.n_cycles_of_search, 0);
  EXPECT_GT(direct.friction.n_cycles_of_search, 0);
  plain.amplitude = direct.friction.amplitude;
  const auto n_plain = stuck_rings(plain, moderate.motion), n_direct = stuck_rings(direct.friction, moderate.motion);
  EXPECT_LT(n_plain.first_slip, n_plain.shakedown);
  EXPECT_EQ(n_direct.first_slip, n_plain.first_slip);
  EXPECT_EQ(n_direct.shakedown, n_plain.shakedown);
  EXPECT_NEAR(radius_of(direct.friction.first_slip_reserve, n_direct.first_slip),
              radius_of(plain.first_slip_reserve, n_plain.first_slip), 2e-5);  // of the way to the periodic state
  EXPECT_NEAR(radius_of(direct.friction.shakedown_reserve, n_direct.shakedown),
              radius_of(plain.shakedown_reserve, n_plain.shakedown), 1e-6);
  EXPECT_LT((direct.friction.traction - plain.traction).cwiseAbs().maxCoeff(), 1e-9);
  const double work = plain.friction_work.sum();
  EXPECT_NEAR(direct.friction.friction_work.sum(), work, 1e-9 * work);
  // By the punches: a ring that is held at its friction limit slips by roundoff, and does not belong to those that
  // slip.
  EXPECT_NEAR(direct.friction.dissipated_energy, plain.dissipated_energy, 1e-9 * work);
}

/// g(c) = c^2 = d0 - (M+ + M-)/2, docs/theory.md.
double shakedown_radius(const Case& one) {
  const double rho = std::abs(stiffening_at(one.model, 1)), a = one.motion.tangential[0].amplitude / (1.5 * mu),
               normal = one.motion.normal[0].amplitude, phase = one.motion.tangential[0].phase;
  const double forward = std::hypot(a * std::cos(phase) - normal, a * std::sin(phase)),
               backward = std::hypot(a * std::cos(phase) + normal, a * std::sin(phase));
  return std::sqrt(one.motion.indentation - rho * (forward + backward) / 2);
}

class SlowBodies : public testing::TestWithParam<RelaxationModel> {};

// Many thousand cycles of creep, or 300 of jumps along the drift.
TEST_P(SlowBodies, AreDecidedInAFewCycles) {
  const Case slow{GetParam()};
  constexpr int n_steps = 36;
  const auto history = contact_history(slow.normal(n_steps), slow.friction(n_steps), {n_steps, 60, 1e-5});
  EXPECT_LE(history.friction.n_cycles + history.friction.n_cycles_of_search, 25);
  const auto stuck = stuck_rings(history.friction, slow.motion);
  EXPECT_NEAR(radius_of(history.friction.shakedown_reserve, stuck.shakedown), shakedown_radius(slow), 5e-5);
}

INSTANTIATE_TEST_SUITE_P(Of, SlowBodies,
                         testing::Values(RelaxationModel{1, {1}, {100}, 0}, RelaxationModel{1, {9999}, {1}, 0},
                                         RelaxationModel{1, {}, {}, 1e3}, RelaxationModel{1, {1, 5}, {30, 1e4}, 2}));

}  // namespace
}  // namespace fretval::fem::friction_search_test
