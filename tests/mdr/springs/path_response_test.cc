#include "mdr/springs/path_response.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/springs/forced_response.h"
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
    path.indentation.push_back(1 + 0.2 * std::cos(t));
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

// What the indenter puts in over a period is lost, to friction or inside the body.
TEST(PathResponse, LosesWhatTheIndenterPutsIn) {
  const SampledPath path{{2, 2.2, 2.7, 2.9, 3.4}, {0.9, 1.1, 1.1, 0.85, 0.9}, {-0.1, -0.1, 0.12, 0.05, -0.1}, true};
  const auto history = path_course(parabola(1), {1, {1}, {0.1}, 0}, mu, path, {200, 400, 20}).history;
  EXPECT_NEAR(history.indenter_work / (history.friction_work + history.bulk_work), 1, 1e-3);
  EXPECT_EQ(history.time.front(), 2);
  EXPECT_EQ(history.time.back(), 3.4);
  EXPECT_NEAR(history.tangential_displacement.back(), -0.1, 1e-15);
}

TEST(PathResponse, RefusesBadArguments) {
  EXPECT_NE(error_of([] { path_course(parabola(1), elastic(1), mu, {{0}, {1}, {0}, false}); }), "accepted");
  const SampledPath pull{{0, 1}, {1, 1}, {0, 0.3}, false};
  EXPECT_NE(error_of([&] { path_course(parabola(1), elastic(1), mu, pull, {200, 0}); }), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::path_response_test
