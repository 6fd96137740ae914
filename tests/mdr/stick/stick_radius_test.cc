#include "mdr/stick/stick_radius.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr::stick_radius_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

// Depths of order one, a dozen rounding errors.
constexpr double tolerance = 1e-12;

Motion locked(double normal, double tangential, double phase) {
  return {1, normal, tangential, 2, 2, phase};
}

// max over Omega of s A rho cos(Omega + phi) - Delta d rho cos(Omega): sampled, then refined. The maximum is flat, so
// an angle to 1e-8 gives its value to roundoff.
double brute_demand(double tangential, double normal, double phase, double sign) {
  const auto negative = [&](double angle) {
    return normal * std::cos(angle) - sign * tangential * std::cos(angle + phase);
  };
  double best = 0;
  for (int k = 0; k < 640; ++k) {
    const double angle = 0.01 * k;
    if (negative(angle) < negative(best)) best = angle;
  }
  return -boost::math::tools::brent_find_minima(negative, best - 0.01, best + 0.01, 53).second;
}

TEST(StickDepths, AgreeWithExtremaFoundByBruteForce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 300; ++i) {
    const double mu = 0.05 + unit(random);
    const Motion motion = locked(unit(random), unit(random), 4 * pi * (unit(random) - 0.5));
    const PronyBody body = standard_solid(1, 3 * unit(random), 0.2 * unit(random));
    const double rho = modulus_ratio(body, 4 * pi);
    const double tangential = rho * 2 * motion.tangential_amplitude / (3 * mu);
    const double forward = brute_demand(tangential, rho * motion.normal_amplitude, *motion.phase, 1);
    const double backward = brute_demand(tangential, rho * motion.normal_amplitude, *motion.phase, -1);
    const StickDepths depths = stick_depths(body, mu, motion);
    const double scale = 1 + forward + backward;
    EXPECT_NEAR(depths.first_slip, 1 - std::max(forward, backward), tolerance * scale);
    EXPECT_NEAR(depths.shakedown, 1 - (forward + backward) / 2, tolerance * scale);
  }
}

TEST(StickDepths, SymmetricInThePhase) {
  for (int k = 0; k < 32; ++k) {
    const double phase = 0.1 * k;
    const StickDepths depths = stick_depths(elastic(1), 0.5, locked(0.2, 0.1, phase));
    for (const double twin : {-phase, pi - phase, phase + 2 * pi}) {
      const StickDepths other = stick_depths(elastic(1), 0.5, locked(0.2, 0.1, twin));
      EXPECT_NEAR(other.first_slip, depths.first_slip, tolerance);
      EXPECT_NEAR(other.shakedown, depths.shakedown, tolerance);
    }
  }
}

TEST(StickDepths, ShakedownNeverLessAndEqualAtNinetyDegrees) {
  double last_first = -1, last_shake = 2;
  for (int i = 0; i <= 90; ++i) {
    const StickDepths depths = stick_depths(kelvin_voigt(1, 0.1), 0.5, locked(0.2, 0.1, i * pi / 180));
    EXPECT_GE(depths.shakedown, depths.first_slip);
    // From 0 to 90 degrees one rises and the other falls.
    EXPECT_GE(depths.first_slip, last_first - tolerance);
    EXPECT_LE(depths.shakedown, last_shake + tolerance);
    last_first = depths.first_slip;
    last_shake = depths.shakedown;
  }
  EXPECT_NEAR(last_first, last_shake, tolerance);
}

// At phi0 = 0 with k >= 1 the shakedown zone is all that keeps contact, A and Delta d no longer matter separately.
TEST(StickDepths, InPhase) {
  EXPECT_NEAR(stick_depths(elastic(1), 1, locked(0.3, 0.3, 0)).shakedown, 0.7, tolerance);
  EXPECT_NEAR(stick_depths(elastic(1), 1, locked(0.2, 0.45, 0)).shakedown, 0.7, tolerance);
  EXPECT_NEAR(stick_depths(elastic(1), 1, locked(0.3, 0.3, 0)).first_slip, 0.5, tolerance);
  // A = Delta d at phi0 = pi: no cancellation.
  EXPECT_NEAR(stick_depths(elastic(1), 1, locked(0.2, 0.3, pi)).first_slip, 0.6, tolerance);
  EXPECT_NEAR(stick_depths(elastic(1), 1, locked(0.2, 0.3, pi)).shakedown, 0.8, tolerance);
}

TEST(StickDepths, OneAmplitudeZeroMakesThePhaseIrrelevant) {
  for (const double phase : {0.0, 0.7, pi / 2}) {
    const StickDepths tangential = stick_depths(elastic(1), 0.5, locked(0, 0.3, phase));
    EXPECT_NEAR(tangential.first_slip, 0.6, tolerance);
    EXPECT_NEAR(tangential.shakedown, 0.6, tolerance);
    const StickDepths normal = stick_depths(elastic(1), 0.5, locked(0.3, 0, phase));
    EXPECT_NEAR(normal.first_slip, 0.7, tolerance);
    EXPECT_NEAR(normal.shakedown, 0.7, tolerance);
  }
  EXPECT_EQ(stick_depths(elastic(1), 0.5, locked(0, 0, 1)).first_slip, 1);
}

TEST(StickDepths, UnlockedPhaseUsesEachFrequencysOwnModulus) {
  const PronyBody body = kelvin_voigt(1, 0.1);
  const Motion motion{1, 0.05, 0.03, 1, 5, std::nullopt};
  const double expected = 1 - (2 * 0.03 / 1.5 * std::hypot(1, 0.1 * 2 * pi * 5) + 0.05 * std::hypot(1, 0.1 * 2 * pi));
  const StickDepths depths = stick_depths(body, 0.5, motion);
  EXPECT_NEAR(depths.first_slip, expected, tolerance);
  EXPECT_NEAR(depths.shakedown, expected, tolerance);
}

TEST(StickRadii, InvertTheProfileOrAreEmpty) {
  const StickRadii radii = stick_radii(parabola(4), elastic(1), 1, locked(0.3, 0.3, 0));
  EXPECT_NEAR(*radii.first_slip, std::sqrt(4 * 0.5), tolerance);
  EXPECT_NEAR(*radii.shakedown, std::sqrt(4 * 0.7), tolerance);
  // First slip everywhere, but a core shakes down.
  const StickRadii core = stick_radii(parabola(4), elastic(1), 1, locked(0.6, 0.9, 0));
  EXPECT_FALSE(core.first_slip);
  EXPECT_NEAR(*core.shakedown, std::sqrt(4 * 0.4), tolerance);
  // rho Delta d = d0: contact is lost everywhere.
  const StickRadii none = stick_radii(parabola(4), elastic(1), 1, locked(1, 0, 0));
  EXPECT_FALSE(none.first_slip);
  EXPECT_FALSE(none.shakedown);
}

// Inside c a worn profile is the unworn one, and outside it carries nothing.
TEST(StickRadii, OfAWornProfileAreThoseOfTheUnwornOneButAtMostItsOwn) {
  const auto motion = locked(0.3, 0.3, 0);  // unworn: sqrt(4 0.5) and sqrt(4 0.7)
  const auto worn_to = [&](double c) {
    return stick_radii(limiting_profile(parabola(4), c, 1.3), elastic(1), 1, motion);
  };
  EXPECT_EQ(*worn_to(1.2).first_slip, 1.2);
  EXPECT_EQ(*worn_to(1.2).shakedown, 1.2);
  EXPECT_NEAR(*worn_to(1.5).first_slip, std::sqrt(2), tolerance);
  EXPECT_EQ(*worn_to(1.5).shakedown, 1.5);
  EXPECT_NEAR(*worn_to(2).shakedown, std::sqrt(2.8), tolerance);
  const auto of_harmonics =
      stick_radii(limiting_profile(parabola(4), 1.5, 1.3), elastic(1), 1, harmonic_motion(motion));
  EXPECT_NEAR(*of_harmonics.first_slip, std::sqrt(2), tolerance);
  EXPECT_EQ(*of_harmonics.shakedown, 1.5);
  EXPECT_FALSE(stick_radii(limiting_profile(parabola(4), 1, 2), elastic(1), 1, locked(1, 0, 0)).shakedown);
}

TEST(StickRadii, RejectBadArguments) {
  const auto depths = [](double mu, const Motion& motion) { return stick_depths(elastic(1), mu, motion); };
  EXPECT_THROW(depths(0, locked(0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(depths(nan, locked(0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(depths(0.5, locked(-0.1, 0.1, 0)), std::invalid_argument);
  EXPECT_THROW(depths(0.5, locked(0.1, nan, 0)), std::invalid_argument);
  EXPECT_THROW(depths(0.5, locked(0.1, 0.1, nan)), std::invalid_argument);
  EXPECT_THROW(depths(0.5, (Motion{0, 0.1, 0.1, 1, 1, 0.0})), std::invalid_argument);
  EXPECT_THROW(depths(0.5, (Motion{1, 0.1, 0.1, 0, 1, std::nullopt})), std::invalid_argument);
  EXPECT_THROW(depths(0.5, (Motion{1, 0.1, 0.1, 1, nan, 0.0})), std::invalid_argument);
}

TEST(StickRadii, NothingSticksWhereADepthIsNotPositive) {
  EXPECT_FALSE(stick_radii(parabola(1), {-0.1, 0}).first_slip);
  EXPECT_NEAR(*stick_radii(parabola(1), {-0.1, 0.25}).shakedown, 0.5, 1e-15);
}

}  // namespace
}  // namespace fretval::mdr::stick_radius_test
