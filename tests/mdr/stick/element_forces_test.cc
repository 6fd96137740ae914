#include "mdr/stick/element_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::element_forces_test {
namespace {

// A dozen rounding errors.
constexpr double tolerance = 1e-12;

TEST(ElementForces, ElasticElementFollowsTheIndenter) {
  const Motion motion{1, 0.2, 0.3, 2, 5, 0.7};
  for (const double time : {0.0, 0.13, 0.4}) {
    EXPECT_NEAR(element_normal_force(elastic(3), motion, 0.4, time), 12 * (0.6 + 0.2 * std::cos(4 * pi * time)), 1e-12);
    EXPECT_NEAR(element_tangential_force(elastic(3), motion, time), 8 * 0.3 * std::cos(10 * pi * time + 0.7), 1e-12);
  }
}

TEST(ElementForces, DisplacementsAreThoseOfTheIndenterLessTheProfile) {
  const Motion motion{1, 0.2, 0.3, 2, 5, 0.7};
  const ElementDisplacement u = element_displacement(motion, 0.4, 0.13);
  EXPECT_NEAR(u.normal, 0.6 + 0.2 * std::cos(4 * pi * 0.13), tolerance);
  EXPECT_NEAR(u.tangential, 0.3 * std::cos(10 * pi * 0.13 + 0.7), tolerance);
}

// (17) is the friction limit of the two forces, so it changes sign at the first-slip depth and at one instant only.
TEST(ElementForces, FrictionMarginIsWhatIsLeftOfTheLimit) {
  const Motion motion{1, 0.1, 0.2, 2, 2, 0.7};
  const Rheology body = standard_solid(1, 3, 0.2);
  const double depth = stick_depths(body, 0.5, motion).first_slip;
  double least = std::numeric_limits<double>::max();
  for (int k = 0; k < 4000; ++k) {
    const double time = 0.5 * k / 4000, margin = element_friction_margin(body, 0.5, motion, depth, time);
    EXPECT_NEAR(
        margin,
        0.5 * element_normal_force(body, motion, depth, time) - std::abs(element_tangential_force(body, motion, time)),
        tolerance);
    least = std::min(least, margin);
  }
  EXPECT_NEAR(least, 0, 1e-5);  // samples: (2 pi/4000)^2 of the force
  EXPECT_THROW(element_friction_margin(body, 0, motion, depth, 0), std::invalid_argument);
}

// Spring and dashpot by hand: force = 4 (G u + eta du/dt), the derivative as a central difference of error h^2.
TEST(ElementForces, DashpotForceIsTheRateOfDisplacement) {
  const double h = 1e-5;
  const Motion motion{1, 0.2, 0.3, 0.5, 0.5, 0.7};
  const auto elastic_force = [&](double t) { return element_normal_force(elastic(1), motion, 0.4, t); };
  const auto elastic_pull = [&](double t) { return element_tangential_force(elastic(1), motion, t); };
  for (const double t : {0.1, 0.9, 1.7}) {
    EXPECT_NEAR(element_normal_force(kelvin_voigt(1, 0.3), motion, 0.4, t),
                elastic_force(t) + 0.3 * (elastic_force(t + h) - elastic_force(t - h)) / (2 * h), 1e-9);
    EXPECT_NEAR(element_tangential_force(kelvin_voigt(1, 0.3), motion, t),
                elastic_pull(t) + 0.3 * (elastic_pull(t + h) - elastic_pull(t - h)) / (2 * h), 1e-9);
  }
}

// min over a cycle of (mu q_z - |q_x|)/(4 G0), from samples and their refinement.
double least_margin(const Rheology& body, double mu, const Motion& motion, double depth) {
  double least = std::numeric_limits<double>::max();
  const double step = 1 / motion.normal_frequency / 200;
  for (const double sign : {1.0, -1.0}) {
    const auto margin = [&](double t) {
      return (mu * element_normal_force(body, motion, depth, t) - sign * element_tangential_force(body, motion, t)) /
             (4 * relaxed_modulus(body));
    };
    double best = 0;
    for (int i = 0; i < 200; ++i)
      if (margin(i * step) < margin(best)) best = i * step;
    least = std::min(least, boost::math::tools::brent_find_minima(margin, best - step, best + step, 45).second);
  }
  return least;
}

TEST(ElementForces, NoSlipConditionHoldsUpToTheFirstSlipDepth) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0, 1);
  const Rheology bodies[] = {elastic(2), kelvin_voigt(1, 0.1), standard_solid(1, 3, 0.2),
                             FractionalZener{1, 3, 0.1, 0.6}};
  for (int i = 0; i < 200; ++i) {
    const Rheology& body = bodies[i % 4];
    const double mu = 0.1 + unit(random);
    const Motion motion{1, 0.3 * unit(random), 0.3 * unit(random), 0.7, 0.7, 6 * unit(random)};
    const double depth = stick_depths(body, mu, motion).first_slip;
    const double scale = 1 + std::abs(depth);
    EXPECT_NEAR(least_margin(body, mu, motion, depth), 0, tolerance * scale);
    // The margin grows by mu per depth.
    EXPECT_NEAR(least_margin(body, mu, motion, depth + 1e-3), -1e-3 * mu, tolerance * scale);
    EXPECT_NEAR(least_margin(body, mu, motion, depth - 1e-3), 1e-3 * mu, tolerance * scale);
  }
}

TEST(ElementForces, RejectBadArguments) {
  const Motion unlocked{1, 0.2, 0.3, 2, 5, std::nullopt};
  EXPECT_NO_THROW(element_normal_force(elastic(1), unlocked, 0, 0));
  EXPECT_THROW(element_tangential_force(elastic(1), unlocked, 0), std::invalid_argument);
  EXPECT_THROW(element_displacement(unlocked, 0, 0), std::invalid_argument);
  EXPECT_THROW(element_normal_force(elastic(1), unlocked, NAN, 0), std::invalid_argument);
  EXPECT_THROW(element_normal_force(elastic(1), unlocked, 0, INFINITY), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::element_forces_test
