#include "mdr/springs/spring_foundation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/support/constants.h"
#include "tests/mdr/marched_spring.h"

namespace fretval::mdr::spring_foundation_test {
namespace {

// Frequency 1/(2 pi) Hz: omega = 1 rad/s.
Motion oscillation(double indentation, double amplitude) {
  return {indentation, amplitude, 0, 1 / (2 * pi), 1 / (2 * pi), std::nullopt};
}

NormalResponse unworn_response(const Profile& profile, const PronyBody& body, const Motion& motion) {
  return periodic_normal_response([&](double x) { return transform(profile, x); },
                                  inverse_transform(profile, maximum_indentation(motion)), body, motion,
                                  transform_kinks(profile));
}

// Quadrature error of 20 points on the smoothed integrand.
constexpr double accuracy = 1e-8;

TEST(SpringFoundation, ElasticBodyFollowsTheClosedForm) {
  for (const Profile& profile : {parabola(5), cone(0.3), power_law(2, 3.7), power_law(0.2, 0.5),
                                 truncated_sphere(5, 0.8), rounded_flat(0.7, 2)}) {
    for (const double amplitude : {0.1, 0.2, 0.5}) {
      const NormalResponse response = unworn_response(profile, elastic(3), oscillation(0.2, amplitude));
      const double largest = normal_force(profile, 3, 0.2 + amplitude);
      EXPECT_NEAR(response.normal_force_max / largest, 1, accuracy);
      EXPECT_NEAR(response.normal_force_min / largest,
                  normal_force(profile, 3, std::max(0.0, 0.2 - amplitude)) / largest, accuracy);
      EXPECT_NEAR(response.contact_radius_max, contact_radius(profile, 0.2 + amplitude), 1e-9);
      for (std::size_t k = 0; k < response.time.size(); ++k) {
        const double expected = normal_force(profile, 3, std::max(0.0, response.indentation[k]));
        EXPECT_NEAR(response.normal_force[k] / largest, expected / largest, accuracy);
      }
    }
  }
}

// The limiting profile's stick area keeps contact: F = 8 [G0 (d0 c - int g) + Delta d |G| c cos(omega t + phi1)].
TEST(SpringFoundation, PermanentContactIsHarmonic) {
  const Profile unworn = parabola(5);
  const PronyBody body = standard_solid(3, 6, 0.7);
  const Motion motion = oscillation(0.2, 0.03);
  const double c = inverse_transform(unworn, 0.1);
  const LimitingProfile worn = limiting_profile(unworn, c, maximum_indentation(motion));
  const NormalResponse response =
      periodic_normal_response([&](double x) { return transform(worn, x); }, c, body, motion);
  const double mean = limiting_normal_force(worn, 3, 0.2);
  const double swing = 8 * 0.03 * c * 3 * modulus_ratio(body, 1);
  EXPECT_NEAR(response.normal_force_max, mean + swing, 1e-10);  // Brent's method on a flat maximum
  EXPECT_NEAR(response.normal_force_min, mean - swing, 1e-10);
  EXPECT_EQ(response.contact_radius_max, c);
  // Of the parabola up to c, and of a flat punch on top.
  const double on_top = (0.2 - 0.1 + 0.03 * modulus_ratio(body, 1)) / c;
  EXPECT_NEAR(response.axis_pressure.value().largest, 4 * 3 / pi * (2 * c / 5 + on_top), 1e-9);
}

// Midpoint rule over marched springs. Its error: the square of the spacing and of the step, and with a dashpot, whose
// force jumps at the edge of the contact, their first power.
double marched_maximum(const Profile& profile, const PronyBody& body, const Motion& motion, int n_springs,
                       int n_steps) {
  const double outer = inverse_transform(profile, maximum_indentation(motion));
  std::vector<double> total(n_steps, 0);
  for (int i = 0; i < n_springs; ++i) {
    const double x = outer * (i + 0.5) / n_springs;
    const double y = (motion.indentation - transform(profile, x)) / motion.normal_amplitude;
    const std::vector<double> cycle = marched_cycle(body, y, n_steps, 8);
    std::transform(cycle.begin(), cycle.end(), total.begin(), total.begin(), std::plus<>());
  }
  return 8 * body.relaxed_modulus * motion.normal_amplitude * outer / n_springs *
         *std::max_element(total.begin(), total.end());
}

TEST(SpringFoundation, ViscoelasticWithContactLossAgreesWithMarching) {
  for (const double amplitude : {0.1, 0.4}) {
    const Motion motion = oscillation(0.2, amplitude);
    for (const PronyBody& body : {standard_solid(1, 2, 0.8), prony(1, {2, 1}, {0.1, 2})}) {
      const double marched = marched_maximum(parabola(5), body, motion, 400, 1000);
      EXPECT_NEAR(unworn_response(parabola(5), body, motion).normal_force_max / marched, 1, 5e-6);
    }
  }
}

// The first order is removed by extrapolation; what is left is the scatter of the maximum among samples.
TEST(SpringFoundation, DashpotWithContactLossAgreesWithMarching) {
  for (const double amplitude : {0.1, 0.4}) {
    const Motion motion = oscillation(0.2, amplitude);
    for (const PronyBody& body : {kelvin_voigt(1, 0.7), prony(1, {2}, {1}, 0.3)}) {
      const double coarse = marched_maximum(parabola(5), body, motion, 500, 500);
      const double fine = marched_maximum(parabola(5), body, motion, 1000, 1000);
      EXPECT_NEAR(unworn_response(parabola(5), body, motion).normal_force_max / (2 * fine - coarse), 1, 5e-5);
    }
  }
}

// f = b r^n on an elastic body, or a flat punch of radius c: p(0) = (4 G/pi) int g'/x dx + 4 G (d - g(c))/(pi c).
TEST(SpringFoundation, PressureOnTheAxisOfAnElasticBodyHasAClosedForm) {
  for (const double n : {1.1, 1.3, 1.5, 2.0, 3.7})
    for (const double amplitude : {0.0, 0.1, 0.5}) {  // contact is lost with the last one
      const Profile profile = power_law(0.3, n);
      const double a = contact_radius(profile, 0.2 + amplitude), g = 0.2 + amplitude;
      const double exact = 4 * 3 / pi * n / (n - 1) * g / a;
      const auto pressure = unworn_response(profile, elastic(3), oscillation(0.2, amplitude)).axis_pressure;
      EXPECT_NEAR(pressure.value().largest / exact, 1, 1e-8) << n << " " << amplitude;
      EXPECT_EQ(pressure->error, 0);
    }
  const double b = 0.3, edge = 2, a = contact_radius(rounded_flat(b, edge), 0.3);
  // Second method: int_b^a g'/x dx by the midpoint rule over g.
  const Profile flat = rounded_flat(b, edge);
  double sum = 0;
  const int n = 20000;
  for (int k = 0; k < n; ++k) {
    const double inner = b + (a - b) * k / n, outer = b + (a - b) * (k + 1) / n;
    sum += (transform(flat, outer) - transform(flat, inner)) * 2 / (inner + outer);
  }
  EXPECT_NEAR(unworn_response(flat, elastic(3), oscillation(0.2, 0.1)).axis_pressure.value().largest, 4 * 3 / pi * sum,
              1e-7 * sum);
}

TEST(SpringFoundation, PressureOfADashpotThatIsTouchedAnewHasNoBound) {
  EXPECT_TRUE(unworn_response(parabola(5), kelvin_voigt(1, 0.7), oscillation(0.2, 0.1)).axis_pressure);
  EXPECT_FALSE(unworn_response(parabola(5), kelvin_voigt(1, 0.7), oscillation(0.2, 0.4)).axis_pressure);
  EXPECT_TRUE(unworn_response(parabola(5), standard_solid(1, 2, 0.8), oscillation(0.2, 0.4)).axis_pressure);
}

TEST(SpringFoundation, PressureUnderASharpTipHasNoBound) {
  EXPECT_FALSE(unworn_response(cone(0.3), elastic(3), oscillation(0.2, 0.1)).axis_pressure);
  EXPECT_FALSE(unworn_response(power_law(0.2, 0.5), elastic(3), oscillation(0.2, 0)).axis_pressure);
  EXPECT_TRUE(unworn_response(power_law(0.2, 1.1), elastic(3), oscillation(0.2, 0.1)).axis_pressure);
}

// Guard: without the rheology, and with the springs allowed to pull, the answer would be another.
TEST(SpringFoundation, RheologyAndUnilateralContactMatter) {
  const Motion motion = oscillation(0.2, 0.15);
  const PronyBody body = standard_solid(1, 2, 0.8);
  const NormalResponse response = unworn_response(parabola(5), body, motion);
  EXPECT_GT(response.normal_force_max, 1.05 * normal_force(parabola(5), 1, 0.35));
  EXPECT_GE(response.normal_force_min, 0);
  const double outer = std::sqrt(5 * 0.35);
  const double pulling = 8 * (0.2 * outer - std::pow(outer, 3) / 15 + 0.15 * outer * modulus_ratio(body, 1));
  EXPECT_GT(std::abs(response.normal_force_max / pulling - 1), 1e-2);
}

// A very slow and a very fast oscillation are elastic ones, of the moduli G0 and, about the relaxed state, G0 + G1.
TEST(SpringFoundation, SlowOscillationIsRelaxed) {
  const Motion motion = oscillation(0.2, 0.15);
  const NormalResponse response = unworn_response(parabola(5), standard_solid(1, 2, 1e-7), motion);
  // First order in omega tau, times G1/G0.
  EXPECT_NEAR(response.normal_force_max / normal_force(parabola(5), 1, 0.35), 1, 1e-6);
}

// Springs that lose contact make up a share of order Delta d/d0; nothing is left of it but the harmonic.
TEST(SpringFoundation, VanishingAmplitudeIsHarmonic) {
  const PronyBody body = standard_solid(1, 2, 0.8);
  const double rest = normal_force(parabola(5), 1, 0.2);
  for (const double amplitude : {1e-5, 1e-9, 1e-13}) {
    const NormalResponse response = unworn_response(parabola(5), body, oscillation(0.2, amplitude));
    const double swing = 8 * amplitude * modulus_ratio(body, 1);
    // Second order in the amplitude, and roundoff.
    EXPECT_NEAR(response.normal_force_max, rest + swing, 100 * amplitude * amplitude + 1e-14);
    EXPECT_NEAR(response.normal_force_min, rest - swing, 100 * amplitude * amplitude + 1e-14);
  }
}

TEST(SpringFoundation, WithoutNormalAmplitudeTheForceIsConstant) {
  const NormalResponse response =
      periodic_normal_response([](double x) { return x * x / 5; }, 2, standard_solid(1, 2, 0.8), oscillation(0.2, 0));
  EXPECT_NEAR(response.normal_force_max / normal_force(parabola(5), 1, 0.2), 1, accuracy);
  EXPECT_EQ(response.normal_force_min, response.normal_force_max);
  EXPECT_EQ(response.normal_force.size(), response.time.size());
  EXPECT_NEAR(response.contact_radius_max, 1, 1e-9);
}

TEST(SpringFoundation, SeriesCoversOneCycle) {
  const Motion motion = oscillation(0.2, 0.1);
  const NormalResponse response = unworn_response(parabola(5), kelvin_voigt(1, 0.7), motion);
  ASSERT_EQ(response.time.size(), response.normal_force.size());
  ASSERT_EQ(response.indentation.size(), response.normal_force.size());
  EXPECT_EQ(response.time.front(), 0);
  EXPECT_NEAR(response.time.back(), 2 * pi, 1e-14);
  EXPECT_NEAR(response.indentation.front(), 0.3, 1e-15);
  EXPECT_EQ(response.normal_force.front(), response.normal_force.back());
  EXPECT_GE(response.normal_force_max, *std::max_element(response.normal_force.begin(), response.normal_force.end()));
  EXPECT_LE(response.normal_force_min, *std::min_element(response.normal_force.begin(), response.normal_force.end()));
}

// From frozen to instantaneous branches, also where the contact opens in every cycle: finite, bounded by the two
// elastic limits, and within the stated 1e-7 of its limit for slow branches.
TEST(SpringFoundation, AnyRelaxationTimeHasAPeriodicState) {
  const Motion motion{1, 0.8, 0, 1 / (2 * pi), 1 / (2 * pi), {}};
  const auto g = [](double x) { return x * x; };
  const double outer = std::sqrt(1.8);
  const auto largest = [&](const PronyBody& body) {
    const NormalResponse response = periodic_normal_response(g, outer, body, motion);
    EXPECT_TRUE(std::isfinite(response.normal_force_min));
    return response.normal_force_max;
  };
  const double relaxed = largest(elastic(1)), frozen = largest(standard_solid(1, 2, 1e12));
  EXPECT_NEAR(largest(standard_solid(1, 2, 1e-12)) / relaxed, 1, 1e-9);
  for (int decade = -12; decade <= 12; decade += 2) {
    const double force = largest(standard_solid(1, 2, std::pow(10, decade)));
    EXPECT_GE(force, relaxed * (1 - 1e-7)) << decade;
    EXPECT_LE(force, 3 * relaxed) << decade;
    if (decade > 7) {
      EXPECT_NEAR(force / frozen, 1, 10 * std::pow(10, -decade) + 1e-11) << decade;
    }
    EXPECT_TRUE(std::isfinite(largest(kelvin_voigt(1, std::pow(10, decade))))) << decade;
  }
}

TEST(SpringFoundation, RejectsBadArguments) {
  const auto g = [](double x) { return x * x; };
  const auto nan_profile = [](double) { return std::numeric_limits<double>::quiet_NaN(); };
  const Motion motion = oscillation(0.2, 0.1);
  EXPECT_THROW(periodic_normal_response(g, 0, elastic(1), motion), std::invalid_argument);
  EXPECT_THROW(periodic_normal_response(nan_profile, 1, elastic(1), motion), std::invalid_argument);
  EXPECT_THROW(periodic_normal_response([](double) { return 1.0; }, 1, elastic(1), motion), std::invalid_argument);
  EXPECT_THROW(periodic_normal_response(g, 1, PronyBody{0, {1}, {1}}, motion), std::invalid_argument);
  EXPECT_THROW(periodic_normal_response(g, 1, elastic(1), oscillation(-1, 0.1)), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::spring_foundation_test
