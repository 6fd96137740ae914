#include "mdr/springs/periodic_spring.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "mdr/support/constants.h"
#include "tests/mdr/marched_spring.h"
#include "tests/worse.h"

namespace fretval::mdr::periodic_spring_test {
namespace {

double ratio(const SpringModel& model) {
  return std::hypot(model.storage, model.loss);
}

// Largest difference from the marched force over a cycle. A dashpot's force jumps at touch-down, so samples within one
// step of it are left out.
double marching_error(const PronyBody& body, double y, int n_steps) {
  const SpringModel model = spring_model(body, 1);
  const PeriodicSpring spring = periodic_spring(model, y);
  const std::vector<double> marched = marched_cycle(body, y, n_steps, 12);
  double error = 0;
  for (int k = 1; k <= n_steps; ++k) {
    const double theta = 2 * pi * k / n_steps;
    if (body.viscosity > 0 && std::abs(theta - spring.touch_down) < 4 * pi / n_steps) continue;
    error = worse(error, std::abs(marched[k - 1] - spring_force(model, spring, theta)));
  }
  return error;
}

TEST(PeriodicSpring, ElasticSpringFollowsTheGap) {
  const SpringModel model = spring_model(elastic(2), 1);
  for (const double y : {-0.99, -0.3, 0.0, 0.6, 1.0, 3.0}) {
    const PeriodicSpring spring = periodic_spring(model, y);
    for (int k = 0; k < 600; ++k) {
      const double theta = 2 * pi * k / 600;
      EXPECT_NEAR(spring_force(model, spring, theta), std::max(0.0, y + std::cos(theta)), 1e-14);
    }
  }
}

TEST(PeriodicSpring, KelvinVoigtRecoversExponentially) {
  const SpringModel model = spring_model(kelvin_voigt(1, 0.5), 1);
  const double y = 0.4;
  const PeriodicSpring spring = periodic_spring(model, y);
  const double depth = y + std::cos(spring.lift_off);
  EXPECT_NEAR(depth, 0.5 * std::sin(spring.lift_off), 1e-14);
  EXPECT_NEAR(depth * std::exp(-(spring.touch_down - spring.lift_off) / 0.5), y + std::cos(spring.touch_down), 1e-13);
}

// Errors of the marching are of second order in the step for a standard solid (its force has no jump) and of first
// order with a dashpot; 2 pi/8000 = 8e-4.
TEST(PeriodicSpring, AgreesWithMarching) {
  for (const double y : {-0.9, -0.2, 0.3, 0.9, 1.2}) {
    EXPECT_LT(marching_error(standard_solid(1, 2, 0.8), y, 8000), 2e-5) << "y = " << y;
    EXPECT_LT(marching_error(prony(1, {2, 1, 0.5}, {0.1, 1, 3}), y, 8000), 2e-5) << "y = " << y;
  }
  // No y close to |G|/G0: where contact is barely lost, the marching finds the jump at touch-down many steps off.
  for (const double y : {-0.9, -0.2, 0.3, 0.9}) {
    EXPECT_LT(marching_error(kelvin_voigt(1, 0.7), y, 8000), 2e-3) << "y = " << y;
    EXPECT_LT(marching_error(prony(1, {2}, {1.5}, 0.3), y, 8000), 3e-3) << "y = " << y;
  }
}

TEST(PeriodicSpring, MarchingErrorVanishesWithTheStep) {
  const double coarse = marching_error(standard_solid(1, 2, 0.8), 0.3, 2000);
  const double fine = marching_error(standard_solid(1, 2, 0.8), 0.3, 8000);
  EXPECT_LT(fine, coarse / 3);  // at least first order: a factor 4
  const double coarse_dashpot = marching_error(kelvin_voigt(1, 0.7), 0.3, 2000);
  EXPECT_LT(marching_error(kelvin_voigt(1, 0.7), 0.3, 8000), coarse_dashpot / 3);
}

// Guard for judging contact by force: a viscoelastic spring lifts off although the indenter is still below the
// undeformed surface, and at y = 1.2 an elastic one would not lift off at all.
TEST(PeriodicSpring, LiftsOffByForceNotByGap) {
  const PeriodicSpring spring = periodic_spring(spring_model(standard_solid(1, 2, 0.8), 1), 1.2);
  EXPECT_GT(spring.touch_down, spring.lift_off);
  EXPECT_GT(1.2 + std::cos(spring.lift_off), 0.1);
}

TEST(PeriodicSpring, ContactIsPermanentFromTheModulusRatioOn) {
  const SpringModel model = spring_model(standard_solid(1, 2, 0.8), 1);
  const PeriodicSpring above = periodic_spring(model, ratio(model));
  EXPECT_EQ(above.touch_down, above.lift_off);
  const PeriodicSpring below = periodic_spring(model, ratio(model) * (1 - 1e-6));
  // Grazing: the harmonic force dips below zero for 2 sqrt(2e-6) radians; contact is lost for about that long.
  EXPECT_NEAR(below.touch_down - below.lift_off, 2 * std::sqrt(2e-6), 2e-3);
  EXPECT_GT(below.touch_down - below.lift_off, 0);
}

// Complementarity and periodicity for rheologies over twelve decades: no tension, and the spring is where it was.
TEST(PeriodicSpring, RandomBodiesPushAndRepeat) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> moduli, times;
    for (int n = i % 6; n > 0; --n) {
      moduli.push_back(std::pow(10, -2 + 5 * unit(random)));
      times.push_back(std::pow(10, -6 + 12 * unit(random)));
    }
    const double viscosity = i % 4 < 2 ? 0 : std::pow(10, -4 + 6 * unit(random));
    const SpringModel model = spring_model(prony(1, moduli, times, viscosity), 1);
    const double rho = ratio(model);
    const PeriodicSpring spring = periodic_spring(model, -1 + (rho + 1) * std::pow(unit(random), 3) + 1e-9);
    double least = 0;
    for (int k = 0; k <= 200; ++k) least = std::min(least, spring_force(model, spring, 2 * pi * k / 200));
    // Newton's error times the moduli.
    EXPECT_GE(least, -1e-8 * rho);
    EXPECT_NEAR(spring_force(model, spring, 0), spring_force(model, spring, 2 * pi), 1e-7 * rho);
  }
}

// A branch too slow for the cycle stays where the mean of the tip is, v = mean(u); the tip is held at the depth that
// gives no force, gamma v/(1 + gamma), while the indenter is above it. v by bisection, the mean in closed form.
double frozen_branch(double y, double gamma) {
  const auto excess = [&](double v) {
    const double rest = gamma * v / (1 + gamma), cosine = std::clamp(rest - y, -1.0, 1.0);
    const double half = std::acos(cosine);  // in contact for |theta| < half
    return (half * y + std::sin(half) + (pi - half) * rest) / pi - v;
  };
  double lower = -10, upper = 10 + y;
  for (int k = 0; k < 200; ++k) (excess((lower + upper) / 2) > 0 ? lower : upper) = (lower + upper) / 2;
  return lower;
}

TEST(PeriodicSpring, VerySlowBranchIsFrozen) {
  for (const double y : {-0.9, -0.2, 0.4, 0.9}) {
    for (const double gamma : {0.1, 2.0, 50.0}) {
      const double v = frozen_branch(y, gamma), rest = gamma * v / (1 + gamma);
      for (const double time : {1e9, 1e12}) {
        const SpringModel model = spring_model(standard_solid(1, gamma, time), 1);
        const PeriodicSpring spring = periodic_spring(model, y);
        for (const double theta : {0.0, 0.3, 1.2}) {
          const double depth = y + std::cos(theta);
          const double force = depth > rest ? depth + gamma * (depth - v) : 0;
          // The next term is of the order of 1/T.
          EXPECT_NEAR(spring_force(model, spring, theta), force, (1e-12 + 10 / time) * (1 + gamma))
              << "y = " << y << ", gamma = " << gamma << ", T = " << time << ", theta = " << theta;
        }
      }
    }
  }
}

TEST(PeriodicSpring, RejectsSpringsThatAreNeverTouched) {
  const SpringModel model = spring_model(elastic(1), 1);
  EXPECT_THROW(periodic_spring(model, -1), std::invalid_argument);
  EXPECT_THROW(periodic_spring(model, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::periodic_spring_test
