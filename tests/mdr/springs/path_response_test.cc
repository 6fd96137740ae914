#include "mdr/springs/path_response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/springs/forced_response.h"
#include "mdr/springs/spring_foundation.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::path_response_test {
namespace {

constexpr double mu = 0.5;

// Hertz: F = 16/3 G sqrt(R) d^1.5; Cattaneo and Mindlin: F_x = mu (F(a) - F(c)), g(c) = d - u_x/(3 mu/2).
TEST(PathResponse, IsCattaneosAndMindlinsPull) {
  const SampledPath pull{{0, 1}, {1, 1}, {0, 0.3}, false};
  const double d_stuck = 1 - 0.3 / (1.5 * mu), hertz = 16.0 / 3 * 2;
  const auto [forces, error, course] = path_forces(parabola(1), elastic(2), mu, pull);
  EXPECT_NEAR(forces.normal_force_max, hertz, 1e-5);
  EXPECT_NEAR(forces.tangential_force_max, mu * hertz * (1 - std::pow(d_stuck, 1.5)), 1e-4);
  EXPECT_NEAR(course.history.depths.first_slip, d_stuck, 1e-10);
  EXPECT_EQ(course.history.n_periods, 1);
}

// A dashpot: at the end of a loading at constant rate v every spring bears its spring and eta v.
TEST(PathResponse, CountsTheDashpotOfAllThatIsInContact) {
  const SampledPath load{{0, 1}, {0.5, 1}, {0, 0}, false};
  const auto [forces, error, course] = path_forces(parabola(1), kelvin_voigt(1, 0.1), mu, load);
  EXPECT_NEAR(forces.normal_force_max, 16.0 / 3 + 8 * 0.1 * 0.5 * 1, 2e-5);
}

// Many rows on cosines against the springs of the oscillation, with the same ramp.
TEST(PathResponse, OfSampledCosinesIsThatOfTheOscillation) {
  constexpr int n = 180;
  SampledPath path{{}, {}, {}, true};
  for (int k = 0; k <= n; ++k) {
    const double t = 2 * pi * (k % n) / n;
    path.time.push_back(static_cast<double>(k) / n);
    path.normal.push_back(1 + 0.2 * std::cos(t));
    path.tangential.push_back(0.15 * std::cos(t + 0.8));
  }
  const PronyBody body{1, {1}, {0.1}, 0};
  const auto sampled = path_forces(parabola(1), body, mu, path).forces;
  const auto exact =
      forced_response(parabola(1), body, mu, {{1, {{0.2, 1, 0}}, {{0.15, 1, 0.8}}}, false, false}).response;
  const double rows = 4 * std::pow(2 * pi / n, 2) / 12;  // of the amplitude, by what is linear between rows
  EXPECT_NEAR(sampled.normal_force_max / exact.normal.normal_force_max, 1, rows);
  EXPECT_NEAR(sampled.tangential_force_max / exact.tangential_force_max, 1, rows);
  EXPECT_NEAR(sampled.friction_work / exact.friction_work, 1, 10 * rows);
  EXPECT_NEAR(sampled.bulk_work / exact.bulk_work, 1, 4 * rows);
}

// A branch that relaxes in 250 periods, against closed forms and springs whose periodic state is found as such.
TEST(PathResponse, OfABodyThatCreepsForLongIsItsPeriodicState) {
  constexpr int n = 180;
  SampledPath path{{}, {}, {}, true};
  for (int k = 0; k <= n; ++k) {
    const double t = 2 * pi * (k % n) / n;
    path.time.push_back(static_cast<double>(k) / n);
    path.normal.push_back(1 + 0.2 * std::cos(t));
    path.tangential.push_back(0.15 * std::cos(t + 0.8));
  }
  const PronyBody body{1, {0.5, 1}, {0.1, 250}, 0};
  const auto stepped = path_forces(parabola(1), body, mu, path);
  EXPECT_LT(stepped.course.history.n_periods, 1000);
  const auto exact =
      periodic_normal_response([](double x) { return x * x; }, std::sqrt(1.2), body, {1, 0.2, 0.15, 1, 1, 0.8});
  const double rows = 4 * std::pow(2 * pi / n, 2) / 12;
  EXPECT_NEAR(stepped.forces.normal_force_max / exact.normal_force_max, 1, rows);
  EXPECT_NEAR(stepped.forces.normal_force_min / exact.normal_force_min, 1, 2 * rows);
  const auto radii = stick_radii(parabola(1), body, mu, HarmonicMotion{1, {{0.2, 1, 0}}, {{0.15, 1, 0.8}}});
  EXPECT_NEAR(std::sqrt(stepped.forces.shakedown), radii.shakedown.value(), rows);
  EXPECT_NEAR(std::sqrt(stepped.forces.first_slip), radii.first_slip.value(), 4 * rows);
}

// What the indenter puts in over a period is lost, to friction or inside the body.
TEST(PathResponse, LosesWhatTheIndenterPutsIn) {
  const SampledPath path{{2, 2.2, 2.7, 2.9, 3.4}, {0.9, 1.1, 1.1, 0.85, 0.9}, {-0.1, -0.1, 0.12, 0.05, -0.1}, true};
  const auto history = path_course(parabola(1), {1, {1}, {0.1}, 0}, mu, path, {200, 400, 20}).history;
  EXPECT_NEAR(history.indenter_work / (history.friction_work + history.bulk_work), 1, 1e-3);
  EXPECT_EQ(history.time.front(), 2);
  EXPECT_EQ(history.time.back(), 3.4);
  EXPECT_NEAR(history.tangential_displacement.back(), -0.1, 1e-15);
}

/// The depth at which Hertz's force, 16/3 G sqrt(R) d^1.5, is so much, of G = 1 and R = 1.
double hertz_depth(double force) {
  return std::pow(3 * force / 16, 2.0 / 3);
}

SampledPath under_forces(SampledPath path, bool normal = true, bool tangential = true) {
  path.normal_force = normal;
  path.tangential_force = tangential;
  return path;
}

// In an elastic body the ring at c has just not slipped where F_N - |F_x|/mu is least, whose Hertzian depth is g(c):
// the tangents of slope mu to the path of the loads (Barber, Davies, Hills 2011); with a periodic state both tangents.
TEST(PathResponse, OfForcesSticksInsideTheTangentsToTheLoads) {
  const auto once = under_forces({{0, 1, 2, 3}, {3, 6, 5, 4}, {0, 0.5, 1.2, -0.4}, false});
  const auto [pass, pass_error, pass_course] = path_forces(parabola(1), elastic(1), mu, once);
  EXPECT_NEAR(pass.first_slip, hertz_depth(5 - 1.2 / mu), 1e-6);
  EXPECT_NEAR(pass.largest_indentation, hertz_depth(6), 1e-6);
  EXPECT_NEAR(pass.tangential_force_max, 1.2, 1e-9);
  const auto forever = under_forces({{0, 1, 2.5}, {4, 6, 4}, {-0.3, 1.2, -0.3}, true});
  const auto [period, error, course] = path_forces(parabola(1), elastic(1), mu, forever);
  EXPECT_NEAR(period.first_slip, hertz_depth(4 - 0.3 / mu), 1e-5);
  EXPECT_NEAR(period.shakedown, hertz_depth((6 - 1.2 / mu + 4 - 0.3 / mu) / 2), 1e-6);
}

// As of oscillating forces, the shakedown radius does not depend on the rheology (docs/theory.md).
TEST(PathResponse, OfForcesShakesDownAlikeInEveryBody) {
  const auto saw = under_forces({{0, 1, 2.5}, {4, 6, 4}, {-0.3, 1.2, -0.3}, true});
  const auto forces = path_forces(parabola(1), standard_solid(1, 1, 0.4), mu, saw).forces;
  EXPECT_NEAR(forces.shakedown, hertz_depth((6 - 1.2 / mu + 4 - 0.3 / mu) / 2), 2e-5);
}

// Forces of a motion, prescribed in turn, lead to the motion: exactly if a row is a step, up to the springs, of which
// there is a bed for each.
TEST(PathResponse, OfTheForcesOfAMotionIsTheMotion) {
  constexpr int n = 120;
  const PronyBody body{1, {1}, {0.1}, 0};
  SampledPath motion{{}, {}, {}, false};
  for (int k = 0; k <= n; ++k) {
    const double t = static_cast<double>(k) / n;
    motion.time.push_back(t);
    motion.normal.push_back(1 + 0.2 * std::sin(7 * t));
    motion.tangential.push_back(0.2 * std::sin(9 * t));
  }
  const PathFineness a_step_a_row{2000, n};
  const auto there = path_course(parabola(1), body, mu, motion, a_step_a_row).history;
  for (const auto& [normal, tangential] : {std::pair(true, true), {true, false}, {false, true}}) {
    auto back = motion;
    if (normal) back.normal = there.normal_force;
    if (tangential) back.tangential = there.tangential_force;
    const auto found = path_course(parabola(1), body, mu, under_forces(back, normal, tangential), a_step_a_row).history;
    for (std::size_t k = 0; k <= n; ++k) {
      ASSERT_NEAR(found.indentation[k], motion.normal[k], 1e-6) << k;
      ASSERT_NEAR(found.tangential_displacement[k], motion.tangential[k], 1e-6) << k;
    }
  }
}

// Rows on a straight line change nothing but the lengths of the steps, over which a dashpot's rates are taken.
TEST(PathResponse, UnderForcesKnowsNoRowsOnAStraightLine) {
  const auto body = kelvin_voigt(1, 0.2);
  for (const auto& [normal, tangential] : {std::pair(true, true), {true, false}, {false, true}}) {
    const double to = normal ? 6 : 1.1, from = normal ? 3 : 0.7, pull = tangential ? 1 : 0.2;
    const auto few = under_forces({{0, 1}, {from, to}, {0, pull}, false}, normal, tangential),
               more = under_forces({{0, 0.001, 0.9, 1},
                                    {from, from + 0.001 * (to - from), from + 0.9 * (to - from), to},
                                    {0, 0.001 * pull, 0.9 * pull, pull},
                                    false},
                                   normal, tangential);
    const auto one = path_forces(parabola(1), body, mu, few).forces,
               other = path_forces(parabola(1), body, mu, more).forces;
    EXPECT_NEAR(one.largest_indentation, other.largest_indentation, 2e-4 * to);
    EXPECT_NEAR(one.normal_force_max, other.normal_force_max, 2e-4 * one.normal_force_max);
    EXPECT_NEAR(one.tangential_amplitude, other.tangential_amplitude, 2e-4);
    EXPECT_NEAR(one.first_slip, other.first_slip, 2e-4 * to);
  }
}

// A body that forgets within a few steps, pulled at a constant rate of the force, F_x = 16/3 G a (u + tau u'): the
// indenter follows at a constant rate, whose path parabolas are, also from one long step to a short one.
TEST(PathResponse, UnderAForceKeepsItsRateFromStepsOfOneLengthToAnother) {
  constexpr double sticks = 1e3, tau = 0.02;
  const auto pull = under_forces({{0, 0.9, 0.901}, {1, 1, 1}, {0, 0.9, 0.901}, false}, false, true);
  const auto history = path_course(parabola(1), kelvin_voigt(1, tau), sticks, pull).history;
  EXPECT_NEAR(history.tangential_displacement.back(), 3.0 / 16 * (0.901 - tau), 1e-12);
}

// |F_x| = mu F_N at t = 25/29, in the middle of a step.
TEST(PathResponse, SaysWhenTheWholeContactSlides) {
  const auto pull = under_forces({{2, 3}, {5, 3}, {0, 1.9}, false});
  try {
    path_forces(parabola(1), elastic(1), mu, pull);
    FAIL() << "accepted";
  } catch (const GrossSlip& slip) {
    EXPECT_NEAR(slip.time, 2 + 25.0 / 29, 1e-12);
    EXPECT_EQ(slip.amplitude, 1);
  }
}

TEST(PathResponse, RefusesBadArguments) {
  EXPECT_NE(error_of([] { path_course(parabola(1), elastic(1), mu, {{0}, {1}, {0}, false}); }), "accepted");
  const SampledPath pull{{0, 1}, {1, 1}, {0, 0.3}, false};
  EXPECT_NE(error_of([&] { path_course(parabola(1), elastic(1), mu, pull, {200, 0}); }), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::path_response_test
