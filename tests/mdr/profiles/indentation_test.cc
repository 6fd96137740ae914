#include "mdr/profiles/indentation.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr::indentation_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double roundoff = 1e-13;  // some rounding errors of pow() and of the quadrature

const double G = 3, d = 0.2;

TEST(Indentation, HertzAndConeForces) {
  EXPECT_NEAR(normal_force(parabola(5), G, d) / (16.0 / 3 * G * std::sqrt(5) * std::pow(d, 1.5)), 1, roundoff);
  EXPECT_NEAR(contact_radius(parabola(5), d), std::sqrt(5 * d), roundoff);
  EXPECT_NEAR(normal_force(cone(0.3), G, d) / (8 * G * d * d / (pi * std::tan(0.3))), 1, roundoff);
  EXPECT_NEAR(contact_radius(cone(0.3), d), 2 * d / (pi * std::tan(0.3)), roundoff);
  EXPECT_EQ(normal_force(parabola(5), G, 0), 0);
}

TEST(Indentation, HertzAndConePressures) {
  const double a = std::sqrt(5 * d);
  for (const double s : {0.0, 0.3, 0.99, 1 - 1e-12}) {
    const double hertz = 4 * G / pi * 2 / 5 * std::sqrt((a - s * a) * (a + s * a));
    EXPECT_NEAR(pressure(parabola(5), G, d, s * a) / hertz, 1, 1e-3 * (s > 0.999) + roundoff);
  }
  const double edge = contact_radius(cone(0.3), d);
  for (const double s : {1e-9, 0.3, 0.99}) {
    const double expected = 2 * G * std::tan(0.3) * std::acosh(1 / s);
    EXPECT_NEAR(pressure(cone(0.3), G, d, s * edge) / expected, 1, roundoff);
  }
  EXPECT_EQ(pressure(parabola(5), G, d, 1.01 * a), 0);
  EXPECT_TRUE(std::isinf(pressure(cone(0.3), G, d, 0)));
}

TEST(Indentation, PressureIntegratesToTheForce) {
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double n : {0.5, 0.8, 1.0, 1.5, 2.0, 3.7, 20.0}) {
    const Profile profile = power_law(0.4, n);
    const double a = contact_radius(profile, d);
    const auto ring = [&](double r) { return 2 * pi * r * pressure(profile, G, d, r); };
    // The axis is left out: for n <= 1 the pressure is infinite there.
    const double force = quadrature.integrate(ring, 1e-100, a, 1e-11);
    // Tolerance of the outer quadrature.
    EXPECT_NEAR(force / normal_force(profile, G, d), 1, 1e-10) << "n = " << n;
  }
}

TEST(Indentation, FullStickForce) {
  EXPECT_NEAR(tangential_force_full_stick(parabola(5), G, d, 0.01), 16.0 / 3 * G * std::sqrt(5 * d) * 0.01, roundoff);
}

TEST(Indentation, CattaneoMindlinRadiusFollowsFromTheForce) {
  const double mu = 0.4;
  for (const double u_x : {0.0, 1e-4, 0.03, 0.1}) {
    const double c = stick_radius_cattaneo_mindlin(parabola(5), mu, d, u_x);
    const double force = tangential_force_cattaneo_mindlin(parabola(5), G, mu, d, u_x);
    const double ratio = std::cbrt(1 - force / (mu * normal_force(parabola(5), G, d)));
    EXPECT_NEAR(c / contact_radius(parabola(5), d), ratio, 1e-12);
  }
  // A small displacement meets the stiffness of full stick; slip costs a share of order u_x/(mu d).
  const double small = tangential_force_cattaneo_mindlin(parabola(5), G, mu, d, 1e-7);
  EXPECT_NEAR(small / tangential_force_full_stick(parabola(5), G, d, 1e-7), 1, 1e-6);
}

TEST(Indentation, SlidingContactCarriesMuTimesTheNormalForce) {
  EXPECT_EQ(stick_radius_cattaneo_mindlin(cone(0.3), 0.4, d, 1), 0);
  EXPECT_NEAR(tangential_force_cattaneo_mindlin(cone(0.3), G, 0.4, d, 1), 0.4 * normal_force(cone(0.3), G, d),
              roundoff);
}

TEST(Indentation, RejectsBadArguments) {
  EXPECT_THROW(contact_radius(parabola(1), -1), std::invalid_argument);
  EXPECT_THROW(normal_force(parabola(1), 0, 1), std::invalid_argument);
  EXPECT_THROW(pressure(parabola(1), 1, 1, nan), std::invalid_argument);
  EXPECT_THROW(tangential_force_full_stick(parabola(1), 1, 1, -1), std::invalid_argument);
  EXPECT_THROW(stick_radius_cattaneo_mindlin(parabola(1), 0, 1, 1), std::invalid_argument);
  EXPECT_THROW(tangential_force_cattaneo_mindlin(parabola(1), 1, nan, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::indentation_test
