#include "mdr/stick/surface_fields.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"
#include "tests/worse.h"

namespace fretval::mdr::surface_fields_test {
namespace {

const double G = 3, R = 5, d = 0.2, mu = 0.4;
const double a = std::sqrt(R * d);

// Hertz, Johnson (1985), equation (3.42a) with p0 = 8 G a/(pi R): the surface outside the contact.
TEST(SurfaceFields, HertzSurface) {
  EXPECT_NEAR(normal_displacement(parabola(R), d, 0.3), d - 0.09 / (2 * R), 1e-15);
  for (const double r : {1.0, 1.2, 3.0, 50.0, 1e4}) {
    const double johnson =
        (std::asin(a / r) * (2 * a * a - r * r) + r * a * std::sqrt((1 - a / r) * (1 + a / r))) / (pi * R);
    // Johnson's form cancels far away, by (r/a)^3.
    EXPECT_NEAR(normal_displacement(parabola(R), d, r), johnson, 1e-15 * (1 + r * r)) << r;
    // There the displacement is that of a point load, F/(4 pi G r) for an incompressible body.
    if (r > 1e3) {
      EXPECT_NEAR(normal_displacement(parabola(R), d, r) / (normal_force(parabola(R), G, d) / (4 * pi * G * r)), 1,
                  1e-7);
    }
  }
}

TEST(SurfaceFields, FarFieldOfEveryProfileIsThatOfAPointLoad) {
  std::vector<double> r, f;
  for (int k = 0; k <= 50; ++k) {
    r.push_back(k * 0.04);
    f.push_back(std::pow(r.back(), 3));
  }
  for (const Profile& profile :
       {cone(0.3), power_law(1, 0.7), rounded_flat(0.5, 1), truncated_sphere(2, 0.3), tabulated(r, f)}) {
    const double point = normal_force(profile, G, d) / (4 * pi * G * 1e4);
    EXPECT_NEAR(normal_displacement(profile, d, 1e4) / point, 1, 1e-7);
  }
}

TEST(SurfaceFields, CattaneoMindlinSticksInsideAndSlidesOutside) {
  const double u_x = 0.05;
  const double c = stick_radius_cattaneo_mindlin(parabola(R), mu, d, u_x);
  boost::math::quadrature::tanh_sinh<double> quadrature;
  const auto traction = [&](double r) { return traction_cattaneo_mindlin(parabola(R), G, mu, d, u_x, r); };
  EXPECT_EQ(tangential_displacement_cattaneo_mindlin(parabola(R), mu, d, u_x, 0.9 * c), u_x);
  EXPECT_NEAR(tangential_displacement_cattaneo_mindlin(parabola(R), mu, d, u_x, c * (1 + 1e-9)), u_x, 1e-10);
  EXPECT_LT(tangential_displacement_cattaneo_mindlin(parabola(R), mu, d, u_x, 0.99 * a), u_x);
  EXPECT_LT(traction(0.5 * c), mu * pressure(parabola(R), G, d, 0.5 * c));
  EXPECT_EQ(traction((a + c) / 2), mu * pressure(parabola(R), G, d, (a + c) / 2));
  EXPECT_EQ(traction(1.1 * a), 0);
  const auto ring = [&](double r) { return 2 * pi * r * traction(r); };
  const double force = quadrature.integrate(ring, 0.0, c, 1e-10) + quadrature.integrate(ring, c, a, 1e-10);
  EXPECT_NEAR(force / tangential_force_cattaneo_mindlin(parabola(R), G, mu, d, u_x), 1, 1e-9);
  // Sliding: the whole traction is mu p, the displacement (3 mu/2) u_z.
  EXPECT_EQ(traction_cattaneo_mindlin(parabola(R), G, mu, d, 1, 0.2), mu * pressure(parabola(R), G, d, 0.2));
  EXPECT_NEAR(tangential_displacement_cattaneo_mindlin(parabola(R), mu, d, 1, 0.2),
              1.5 * mu * normal_displacement(parabola(R), d, 0.2), 1e-15);
}

TEST(SurfaceFields, PressureOfTheWornParabola) {
  const double c = 0.5;
  const LimitingProfile worn = limiting_profile(parabola(R), c, d);
  for (const double r : {0.0, 0.2, 0.499}) {
    const double root = std::sqrt(c * c - r * r);
    const EdgeStress p = limiting_pressure(worn, G, d, r);
    EXPECT_NEAR(p.regular, 4 * G / pi * 2 / R * root, 1e-12);
    EXPECT_NEAR(p.intensity, 4 * G / pi * (d - c * c / R), 1e-12);
    EXPECT_NEAR(total(p, r), p.regular + p.intensity / root, 1e-12);
  }
  EXPECT_TRUE(std::isinf(total(limiting_pressure(worn, G, d, c), c)));
  EXPECT_EQ(total(limiting_pressure(worn, G, d, 0.6), 0.6), 0);
  EXPECT_EQ(total(limiting_pressure(worn, G, 0.01, 0.1), 0.1), pressure(worn.unworn, G, 0.01, 0.1));
  EXPECT_EQ(limiting_pressure(worn, G, 0.01, 0.1).intensity, 0);
}

TEST(SurfaceFields, WornPressureIntegratesToTheForce) {
  for (const double n : {0.5, 1.0, 2.0, 3.7}) {
    const LimitingProfile worn = limiting_profile(power_law(0.1, n), 0.3, d);
    boost::math::quadrature::tanh_sinh<double> quadrature;
    // The axis is left out: for n <= 1 the pressure is infinite there. The singular part integrates to 2 pi K c.
    const auto ring = [&](double r) { return 2 * pi * r * limiting_pressure(worn, G, d, r).regular; };
    const double force =
        quadrature.integrate(ring, 1e-100, 0.3, 1e-10) + 2 * pi * 0.3 * limiting_pressure(worn, G, d, 0).intensity;
    EXPECT_NEAR(force / limiting_normal_force(worn, G, d), 1, 1e-9) << "n = " << n;
  }
}

// In the limiting state the free surface of the body at d_max is the worn flank: that is what the profile is.
TEST(SurfaceFields, WornSurfaceIsTheFlankAtTheLargestIndentation) {
  const LimitingProfile worn = limiting_profile(parabola(R), 0.5, d);
  for (const double r : {0.1, 0.5, 0.6, 0.9}) {
    EXPECT_NEAR(limiting_normal_displacement(worn, d, r), d - shape(worn, r), 1e-14) << r;
  }
  EXPECT_NEAR(limiting_normal_displacement(worn, 0.01, 0.9), normal_displacement(parabola(R), 0.01, 0.9), 1e-16);
}

TEST(SurfaceFields, FullStickTractionIntegratesToTheForce) {
  const LimitingProfile worn = limiting_profile(parabola(R), 0.5, d);
  const EdgeStress traction = limiting_traction(worn, G, 0.01, 0.2);
  EXPECT_NEAR(2 * pi * 0.5 * traction.intensity, 16.0 / 3 * G * 0.5 * 0.01, 1e-15);
  EXPECT_EQ(limiting_tangential_displacement(worn, 0.01, 0.3), 0.01);
  EXPECT_NEAR(limiting_tangential_displacement(worn, 0.01, 1e4) / (2 / pi * 0.01 * 0.5 / 1e4), 1, 1e-8);
}

// The two intensities are in the ratio mu where and when the edge is about to slip: at the first-slip radius.
TEST(SurfaceFields, EdgeIntensitiesMeetTheFrictionLimitAtTheFirstSlipRadius) {
  const Rheology body = standard_solid(2e6, 3e6, 0.1);
  const Motion motion{1e-4, 2e-5, 1.5e-5, 2, 2, 0.7};
  const double c = stick_radii(parabola(0.01), body, mu, motion).first_slip.value();
  const LimitingProfile worn = limiting_profile(parabola(0.01), c, maximum_indentation(motion));
  double worst = 0;
  for (int k = 0; k < 4000; ++k) {
    const LimitingStresses s = limiting_stresses(worn, body, motion, c / 2, 0.5 * k / 4000);
    worst = worse(worst, std::abs(s.traction.intensity) / s.pressure.intensity);
  }
  EXPECT_NEAR(worst / mu, 1, 1e-6);  // sampling: (pi/4000)^2
}

TEST(SurfaceFields, RejectsBadArguments) {
  const LimitingProfile worn = limiting_profile(parabola(R), 0.5, d);
  EXPECT_THROW(normal_displacement(parabola(R), d, -1), std::invalid_argument);
  EXPECT_THROW(limiting_pressure(worn, 0, d, 0.1), std::invalid_argument);
  EXPECT_THROW(limiting_pressure(worn, G, 2 * d, 0.1), std::invalid_argument);
  EXPECT_THROW(limiting_traction(worn, G, NAN, 0.1), std::invalid_argument);
  EXPECT_THROW(traction_cattaneo_mindlin(parabola(R), G, 0, d, 0.1, 0.1), std::invalid_argument);
  const Motion unlocked{0.15, 0.05, 0.01, 1, 1, {}};
  EXPECT_THROW(limiting_stresses(worn, elastic(1), unlocked, 0.1, 0), std::invalid_argument);
  const Motion lifting{0.1, 0.09, 0.01, 1, 1, 0.0};
  EXPECT_THROW(limiting_stresses(worn, elastic(1), lifting, 0.1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::surface_fields_test
