#include "fem/motion/sampled_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/contact/gross_slip.h"
#include "fem/motion/motion.h"
#include "fem/ring_contact/stick_zone/contact_radius.h"
#include "fem/ring_contact/stick_zone/stick_zones.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::sampled_path_test {
namespace {

constexpr double mu = 0.5;

SampledPath saw(bool repeats) {
  return {{0, 1, 1.5, 2 * pi},  {0.8, 1, 0.6, 0.8},   {0.1, 0.3, -0.2, 0.1},
          repeats ? 0.75 : 0.8, repeats ? 0.05 : 0.1, repeats};
}

Motion along_path(const SampledPath& path) {
  Motion motion{path.rest_normal, {}, {}};
  motion.path = path;
  return motion;
}

TEST(SampledPath, IsLinearBetweenItsRowsAndMeetsThem) {
  const auto path = saw(true);
  EXPECT_EQ(along(path, path.normal, 0, 0.5).value, 0.8);
  EXPECT_EQ(along(path, path.normal, 1, 0.5).value, 1);
  EXPECT_EQ(along(path, path.normal, 1, 1.2).value, 1);
  EXPECT_NEAR(along(path, path.normal, 1.25, 1.25).value, 0.8, 1e-15);
  EXPECT_NEAR(along(path, path.normal, 1, 0.5).rate, 0.2, 1e-15);
  EXPECT_NEAR(along(path, path.normal, 1, 1.2).rate, -0.8, 1e-15);
  EXPECT_EQ(along(path, path.normal, 2 * pi, 2 * pi).value, 0.8);
}

TEST(SampledPath, HasAWholeNumberOfEqualStepsForEachPiece) {
  const auto path = saw(true);
  const int n = steps_along(path, 72);
  const auto steps = steps_of(path, n);
  ASSERT_EQ(static_cast<int>(steps.size()), n);
  std::size_t row = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (k > 0) {
      EXPECT_EQ(steps[k].begin, steps[k - 1].end);
    }
    if (steps[k].first) {
      EXPECT_EQ(steps[k].begin, path.time[row]);
    }
    if (steps[k].last) {
      EXPECT_EQ(steps[k].end, path.time[++row]);
    }
    EXPECT_LE(steps[k].duration(), 2 * pi / 72 * (1 + 1e-12));
  }
  EXPECT_EQ(row, path.n_pieces());
}

// So that half of the steps tells the order of their error, however many rows there are.
TEST(SampledPath, HasTwiceTheStepsWhereTwiceAsManyAreWanted) {
  SampledPath dense{{}, {}, {}, 1, 0, true};
  for (int k = 0; k <= 100; ++k) dense.time.push_back(2 * pi * k / 100);
  for (const auto& path : {saw(true), dense})
    for (const int wanted : {9, 18, 36, 72}) EXPECT_EQ(steps_along(path, 2 * wanted), 2 * steps_along(path, wanted));
  EXPECT_EQ(steps_along(dense, 9), 100);
  EXPECT_EQ(steps_along(dense, 14), 200) << "the nearer multiple";
  SampledPath of_nine{{}, {}, {}, 1, 0, true};
  for (int k = 0; k <= 9; ++k) of_nine.time.push_back(0.1 * k * (2 * pi / 0.9));
  EXPECT_EQ(steps_along(of_nine, 9), 9) << "each piece is a ninth of the cycle, to roundoff";
}

TEST(SampledPath, RisesFromRestOrBeginsAtItsFirstRow) {
  auto motion = along_path(saw(true));
  motion.n_ramp_cycles = 2;
  EXPECT_EQ(normal_motion(motion, 0).value, 0.75);
  EXPECT_EQ(tangential_motion(motion, 0).value, 0);
  EXPECT_EQ(normal_motion(motion, 6 * pi + 1).value, 1);
  EXPECT_NEAR(tangential_motion(motion, 6 * pi + 1).value, 0.25, 1e-15);
  EXPECT_EQ(motion.cycles_of_ramp(), 2);
  const auto once = along_path(saw(false));
  EXPECT_EQ(normal_motion(once, 0).value, 0.8);
  EXPECT_EQ(tangential_motion(once, 0).value, 0);
  EXPECT_EQ(once.cycles_of_ramp(), 0);
  EXPECT_NEAR(once.tangential_amplitude(), 0.3, 1e-15);
  EXPECT_NEAR(tangential_path(once), 0.2 + 0.5 + 0.3, 1e-15);
}

// Along y it departs from its own rest.
TEST(SampledPath, MovesAcrossFromItsRestThere) {
  auto path = saw(true);
  path.transverse = {0.4, 0.6, 0.5, 0.4};
  path.rest_transverse = 0.45;
  auto motion = along_path(path);
  motion.n_ramp_cycles = 2;
  EXPECT_NEAR(transverse_motion(motion, 6 * pi + 1).value, 0.15, 1e-14);
  EXPECT_NEAR(transverse_motion(motion, 6 * pi + 1.25).value, 0.1, 1e-14);
  EXPECT_NEAR(transverse_motion_inside(motion, 6 * pi + 1, 6 * pi + 1.2).rate, -0.2, 1e-14);
}

struct Pass {
  NormalHistory normal;
  FrictionHistory friction;
  StickZones zones;
};

Pass pass(const RelaxationModel& body, const Motion& motion, int wanted) {
  constexpr unsigned n = 64;
  const auto &normal = normal_half_space(n), &tangential = tangential_half_space(n);
  const HistoryControl control{steps_along(*motion.path, wanted)};
  auto history =
      normal_history(NormalContact(normal, body, parabola_means(normal), motion, control.steps_per_cycle), control);
  auto friction =
      friction_history(WatchedFriction(tangential, body, mu, motion, control.steps_per_cycle), history, control);
  const auto zones = stick_zones(tangential.compliance, friction, stuck_rings(friction, motion));
  return {std::move(history), std::move(friction), zones};
}

// u_x = (3 mu/2)(d - c^2); F_x = mu (16/3)(d^1.5 - c^3).
TEST(SampledPath, IsCattaneosAndMindlinsPullInOnePass) {
  const SampledPath pull{{0, 2 * pi}, {0.9, 0.9}, {0, 0.3}, 0.9, 0, false};
  const auto [normal, friction, zones] = pass(elastic_body(), along_path(pull), 36);
  const double c = std::sqrt(0.9 - 0.3 / (1.5 * mu));
  EXPECT_NEAR(zones.first_slip.radius, c, 5e-5);  // as friction_history_test.cc measures of oscillations
  EXPECT_NEAR(friction.force.tail(1)[0] / (mu * 16 / 3 * (std::pow(0.9, 1.5) - c * c * c)), 1, 2e-4);
  EXPECT_EQ(friction.n_cycles, 1);
  EXPECT_EQ(friction.n_steps, normal.n_steps());
}

// A fast pull, then a hold, in which the force of what sticks relaxes: T at the end of the pull decides, a row. In
// steps of more than half of its time the branch acts as a dashpot, and forces balance inside them: 3.2e-4 measured,
// order 2.
TEST(SampledPath, KnowsTheForceAtItsRows) {
  const RelaxationModel body{1, {1}, {0.4}, 0};
  const SampledPath pull{{0, 1, 2 * pi}, {0.9, 0.9, 0.9}, {0, 0.2, 0.2}, 0.9, 0, false};
  const double force = 0.2 + 0.4 * 0.2 * (1 - std::exp(-1 / 0.4)), c = std::sqrt(0.9 - force / (1.5 * mu));
  EXPECT_NEAR(pass(body, along_path(pull), 18).zones.first_slip.radius, c, 5e-4);
  EXPECT_NEAR(pass(body, along_path(pull), 72).zones.first_slip.radius, c, 5e-5);
}

// With a dashpot the force jumps where the speed does, and forces balance inside the steps: second order at rows.
TEST(SampledPath, ExtendsForcesOfADashpotToItsRows) {
  const RelaxationModel body{1, {}, {}, 0.3};
  const SampledPath pull{{0, 1, 2 * pi}, {0.9, 0.9, 0.9}, {0, 0.2, 0.2}, 0.9, 0, false};
  const double force = 0.2 + 0.3 * 0.2;
  const auto c = pass(body, along_path(pull), 36).zones.first_slip.radius;
  EXPECT_NEAR(c, std::sqrt(0.9 - force / (1.5 * mu)), 1e-4);
}

// At the fewest steps each row is one.
constexpr int a_step_a_row = 9;

/// Rows of a motion whose pieces are no longer than a step.
SampledPath sampled(int n, double (*normal)(double), double (*tangential)(double)) {
  SampledPath path{{}, {}, {}, normal(0), tangential(0), false};
  for (int k = 0; k <= n; ++k) {
    path.time.push_back(2 * pi * k / n);
    path.normal.push_back(normal(path.time.back()));
    path.tangential.push_back(tangential(path.time.back()));
  }
  return path;
}

// Forces of a motion, prescribed in turn, lead to the motion, if a row is a step: up to where the reading of a force
// jumps as a ring changes its state, next to which two displacements have the same reading.
TEST(SampledPath, OfNormalForcesLeadsToTheMotionThatTheyCameFrom) {
  const RelaxationModel body{1, {1}, {2}, 0};
  constexpr int n = 40;
  auto path = sampled(
      n, [](double t) { return 0.8 + 0.15 * std::sin(t); }, [](double /*t*/) { return 0.0; });
  const auto& problem = normal_half_space(48);
  const auto profile = parabola_means(problem);
  const auto history_of = [&](const Motion& motion) {
    const HistoryControl control{steps_along(*motion.path, a_step_a_row)};
    return normal_history(NormalContact(problem, body, profile, motion, control.steps_per_cycle), control);
  };
  const auto there = history_of(along_path(path));
  ASSERT_EQ(there.force.size(), n);
  auto forces = path;
  const Motion rest = along_path(path);
  forces.rest_normal = forces.normal[0] =
      NormalContact(problem, body, profile, rest, steps_along(path, a_step_a_row)).reading.force;
  for (int k = 0; k < n; ++k) forces.normal[static_cast<std::size_t>(k) + 1] = there.force[k];
  auto motion = along_path(forces);
  motion.normal_force = true;
  const auto back = history_of(motion);
  EXPECT_LT((back.indentation - there.indentation).cwiseAbs().maxCoeff(), 2e-6);
  EXPECT_LT((back.pressure - there.pressure).cwiseAbs().maxCoeff(), 5e-5);
}

TEST(SampledPath, OfTangentialForcesLeadsToTheMotionThatTheyCameFrom) {
  const RelaxationModel body{1, {1}, {2}, 0};
  constexpr int n = 40;
  auto path = sampled(
      n, [](double /*t*/) { return 0.9; }, [](double t) { return 0.25 * std::sin(t) + 0.05 * t; });
  const auto there = pass(body, along_path(path), a_step_a_row);
  auto forces = path;
  for (int k = 0; k < n; ++k) forces.tangential[static_cast<std::size_t>(k) + 1] = there.friction.force[k];
  auto motion = along_path(forces);
  motion.tangential_force = true;
  const auto back = pass(body, motion, a_step_a_row);
  EXPECT_LT((back.friction.indenter - there.friction.indenter).cwiseAbs().maxCoeff(), 5e-6);
  EXPECT_NEAR(back.zones.first_slip.radius, there.zones.first_slip.radius, 1e-6);
  EXPECT_LT((back.friction.traction - there.friction.traction).cwiseAbs().maxCoeff(), 1e-4);
}

// F = 16/3 d^1.5, F_x = mu (F - 16/3 c^3), in steps of two lengths.
TEST(SampledPath, OfBothForcesIsHertzsAndCattaneosAndMindlins) {
  constexpr double full = 16.0 / 3;
  const SampledPath pull{
      {0, 0.7, 2 * pi}, {0.7 * full, 0.8 * full, 0.8 * full}, {0, 0, 0.15 * full}, 0.7 * full, 0, false};
  auto motion = along_path(pull);
  motion.normal_force = motion.tangential_force = true;
  const auto [normal, friction, zones] = pass(elastic_body(), motion, 18);
  const double c = std::cbrt(0.8 - 0.15 / mu);
  EXPECT_NEAR(normal.largest_indentation, std::pow(0.8, 2.0 / 3), 3e-6);
  EXPECT_NEAR(zones.first_slip.radius, c, 5e-5);
  EXPECT_NEAR(friction.indenter.tail(1)[0], 1.5 * mu * (std::pow(0.8, 2.0 / 3) - c * c), 3e-5);
}

// |F_x| = mu F_N at t = 5/6 of the way, between the steps.
TEST(SampledPath, SaysWhenTheWholeContactSlides) {
  const SampledPath pull{{0, 2 * pi}, {5, 3}, {0, 2}, 5, 0, false};
  auto motion = along_path(pull);
  motion.normal_force = motion.tangential_force = true;
  try {
    pass(elastic_body(), motion, 18);
    FAIL() << "accepted";
  } catch (const GrossSlip& slip) {
    EXPECT_NEAR(slip.time, 2 * pi * 5 / 6, 1e-9);
    EXPECT_EQ(slip.amplitude, 1);
  }
}

// A pass that lifts from its first row on is in largest contact there.
TEST(SampledPath, KnowsTheContactThatItBeginsWith) {
  const SampledPath lift{{0, 2 * pi}, {0.9, 0.4}, {0, 0}, 0.9, 0, false};
  const auto& problem = normal_half_space(64);
  const auto motion = along_path(lift);
  const HistoryControl control{steps_along(lift, 18)};
  const auto history = normal_history(
      NormalContact(problem, elastic_body(), parabola_means(problem), motion, control.steps_per_cycle), control);
  const auto events = contact_events(problem.compliance, parabola_means(problem));
  EXPECT_NEAR(largest_contact_radius(history.smallest_gap, events).radius, std::sqrt(0.9), 1e-5);
  EXPECT_NEAR(history.largest_indentation, 0.9, 1e-12);
}

}  // namespace
}  // namespace fretval::fem::sampled_path_test
