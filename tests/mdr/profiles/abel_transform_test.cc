#include "mdr/profiles/abel_transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mdr/profiles/profile.h"

namespace fretval::mdr::abel_transform_test {
namespace {

// Profiles without a closed form: there and back again.
TEST(AbelTransform, RoundTripOfSmoothProfiles) {
  struct Shape {
    double (*height)(double);
    double (*slope)(double);
  };
  const Shape hyperbola{[](double r) { return std::sqrt(1 + r * r) - 1; },
                        [](double r) { return r / std::sqrt(1 + r * r); }};
  const Shape sphere{[](double r) { return 3 - std::sqrt(9 - r * r); },
                     [](double r) { return r / std::sqrt(9 - r * r); }};
  const Shape cosh{[](double r) { return std::cosh(r) - 1; }, [](double r) { return std::sinh(r); }};
  for (const Shape& shape : {hyperbola, sphere, cosh}) {
    const auto image = [&](double x) { return abel_transform(shape.slope, x); };
    for (const double r : {0.05, 0.2, 1.0, 2.5})
      EXPECT_NEAR(abel_back_transform(image, r) / shape.height(r), 1, 1e-10) << r;
  }
}

// The sphere's image is known: g = (x/2) ln((R + x)/(R - x)), Popov and Hess (2015), chapter 3.
TEST(AbelTransform, SphereHasItsClosedForm) {
  for (const double x : {0.01, 1.0, 2.7}) {
    const double g = abel_transform([](double r) { return r / std::sqrt(9 - r * r); }, x);
    EXPECT_NEAR(g / (x / 2 * std::log((3 + x) / (3 - x))), 1, 1e-11);
  }
}

TEST(AbelTransform, AgreesWithTheClosedFormsOfTheProfileKinds) {
  for (const double n : {0.7, 1.0, 2.0, 3.3, 12.0}) {
    const Profile profile = power_law(0.7, n);
    const auto slope = [&](double r) { return shape_slope(profile, r); };
    EXPECT_NEAR(abel_transform(slope, 1.3) / transform(profile, 1.3), 1, n < 1 ? 1e-6 : 1e-11) << n;
  }
}

TEST(AbelTransform, AtTheAxisAndBadArguments) {
  EXPECT_EQ(abel_transform([](double) { return 1.0; }, 0), 0);
  EXPECT_NEAR(abel_back_transform([](double) { return 2.0; }, 0), 2, 1e-12);
  EXPECT_THROW(abel_transform([](double) { return 1.0; }, -1), std::invalid_argument);
  EXPECT_THROW(abel_back_transform([](double) { return std::numeric_limits<double>::quiet_NaN(); }, 1),
               std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::abel_transform_test
