#include "mdr/profiles/sphere.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <string>

#include "mdr/profiles/abel_transform.h"
#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::sphere_test {
namespace {

const double R = 3, G = 2;

TEST(Sphere, IsACircle) {
  for (const double r : {1e-9, 0.1, 1.8, 2.9999, R}) {
    const double f = shape(sphere(R), r);
    EXPECT_NEAR(r * r + (R - f) * (R - f), R * R, 1e-14) << r;
  }
  EXPECT_NEAR(shape(sphere(5), 3), 1, 1e-15);
  EXPECT_NEAR(shape_slope(sphere(5), 3), 0.75, 1e-15);
  EXPECT_EQ(end_radius(sphere(R)), R);
}

// Segedin (1957), Sneddon (1965): d = (a/2) ln((R+a)/(R-a)), F = E*/2 [(a^2+R^2) ln((R+a)/(R-a)) - 2 a R], E* = 4 G.
// At a = R/2 the logarithm is that of 3, at a = 0.8 R that of 9.
TEST(Sphere, HasSneddonsDepthAndForce) {
  for (const auto& [share, ratio] : {std::pair(0.5, 3.0), {0.8, 9.0}}) {
    const double a = share * R, d = a / 2 * std::log(ratio);
    EXPECT_NEAR(contact_radius(sphere(R), d), a, 1e-14);
    const double force = 2 * G * ((a * a + R * R) * std::log(ratio) - 2 * a * R);
    EXPECT_NEAR(normal_force(sphere(R), G, d) / force, 1, 1e-14);
  }
}

// d = a^2/R (1 + (a/R)^2/3), F = 16 G a^3/(3 R) (1 + 2 (a/R)^2/5), and at one depth a is less by (a/R)^2/6.
TEST(Sphere, BeginsAsTheParabola) {
  for (const double t : {1e-2, 1e-4, 1e-7}) {
    const double a = t * R, next = 2 * t * t * t * t + 1e-14, d = transform(sphere(R), a);
    EXPECT_NEAR(d / (a * a / R), 1 + t * t / 3, next);
    EXPECT_NEAR(normal_force(sphere(R), G, d) / (16 * G * a * a * a / (3 * R)), 1 + 2 * t * t / 5, next);
    EXPECT_NEAR(a / contact_radius(parabola(R), d), 1 - t * t / 6, next);
  }
}

TEST(Sphere, TransformsForthAndBack) {
  for (const double x : {1e-6, 0.3, 0.899999, 0.900001, 1.5, 2.9}) {
    EXPECT_NEAR(transform(sphere(R), -x) / abel_transform([](double r) { return shape_slope(sphere(R), r); }, x), 1,
                1e-11);
    EXPECT_NEAR(abel_back_transform([](double y) { return transform(sphere(R), y); }, x) / shape(sphere(R), x), 1,
                1e-11);
    EXPECT_NEAR(inverse_transform(sphere(R), transform(sphere(R), x)) / x, 1, 1e-14);
    const double h = 1e-5 * x;
    EXPECT_NEAR((transform(sphere(R), x + h) - transform(sphere(R), x - h)) / (2 * h) / transform_slope(sphere(R), x),
                1, 1e-7);
    EXPECT_NEAR((transform_integral(sphere(R), x + h) - transform_integral(sphere(R), x - h)) / (2 * h) /
                    transform(sphere(R), x),
                1, 1e-7);
  }
  EXPECT_EQ(inverse_transform(sphere(R), 0), 0);
  EXPECT_NEAR(transform_integral(sphere(R), R), R * R / 2, 1e-14);
}

// int_0^x = int_0^s + int_s^x on both sides of where the series takes over.
TEST(Sphere, VolumeHasNoStepBetweenSeriesAndClosedForm) {
  const double x = 0.3 * R, h = 1e-12;
  EXPECT_NEAR(transform_integral(sphere(R), x + h) - transform_integral(sphere(R), x - h),
              2 * h * transform(sphere(R), x), 1e-15);
}

TEST(Sphere, PressureIntegratesToTheForce) {
  for (const double a : {0.2, 2.4}) {
    const double d = transform(sphere(R), a);
    // The root at r = a is smooth in t with r = a (1 - t^2).
    const auto ring = [&](double t) {
      const double r = a * (1 - t * t);
      return 2 * pi * r * pressure(sphere(R), G, d, r) * 2 * a * t;
    };
    const double force = boost::math::quadrature::gauss<double, 60>::integrate(ring, 0.0, 1.0);
    EXPECT_NEAR(force / normal_force(sphere(R), G, d), 1, 1e-11) << a;
  }
  EXPECT_NEAR(abel_slope_integral(sphere(R), 0, 1e-3) / (2e-3 / R), 1, 1e-6);
}

// The parts of (4), each at the end where its angle is accurate, up to the last radius of the sphere.
TEST(Sphere, DepthIntegralsAddUpToTheHeight) {
  for (const double r : {0.3, 2.0, R})
    for (const double share : {1e-3, 0.5, 0.9, 1 - 1e-9}) {
      const double c = share * r;
      const double parts = abel_depth_integral(sphere(R), 0, c, r) + abel_depth_integral(sphere(R), c, r, r);
      EXPECT_NEAR(2 / pi * parts / shape(sphere(R), r), 1, 1e-11) << r << " " << share;
    }
  // Next to r = 1 the integrand is that of g(1)/sqrt(r^2-x^2).
  const double near = abel_depth_integral(sphere(R), 1 - 1e-12, 1, 1);
  EXPECT_NEAR(near / (transform(sphere(R), 1) * std::acos(1 - 1e-12)), 1, 1e-4);
}

TEST(Sphere, LimitingProfileIsTheBackTransform) {
  const double a = 1.2, c = 0.7, d = transform(sphere(R), a);
  const LimitingProfile worn = limiting_profile(sphere(R), c, d);
  EXPECT_GT(worn.outer_radius, a);
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double s : {0.01, 0.5, 0.99}) {
    const double r = c + s * (worn.outer_radius - c), split = std::asin(c / r);
    const double inner =
        quadrature.integrate([&](double t) { return transform(sphere(R), r * std::sin(t)); }, 0.0, split, 1e-14);
    EXPECT_NEAR(shape(worn, r), 2 / pi * (inner + d * (pi / 2 - split)), 1e-12);
  }
}

TEST(Sphere, EndsAtItsRadius) {
  EXPECT_THROW(sphere(0), std::invalid_argument);
  EXPECT_THROW(shape(sphere(R), 1.001 * R), std::invalid_argument);
  EXPECT_NEAR(contact_radius(sphere(R), 2 * R), 0.96836443 * R, 1e-7 * R);  // u tanh(u) = 2, u = 2.0653381
  const auto message = error_of([] { contact_radius(sphere(R), 8 * R); });
  EXPECT_NE(message.find("24: the contact would reach the radius of the sphere, 3"), std::string::npos) << message;
}

// At d = 2 R nothing sticks but a point: the worn zone would be wider than the sphere.
TEST(Sphere, WornZoneEndsInsideTheSphere) {
  const auto message = error_of([] { limiting_profile(sphere(R), 1e-3, 2 * R); });
  EXPECT_NE(message.find("radius of the sphere = 3: the worn zone would reach it"), std::string::npos) << message;
}

}  // namespace
}  // namespace fretval::mdr::sphere_test
