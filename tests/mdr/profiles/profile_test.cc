#include "mdr/profiles/profile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mdr/support/constants.h"

namespace fretval::mdr::profile_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();

// A few rounding errors of pow() and of the gamma function.
constexpr double roundoff = 1e-14;

TEST(Profile, ParabolaAndConeHaveTheirClosedForms) {
  const Profile sphere = parabola(0.01);
  const Profile spike = cone(0.1);
  for (const double x : {0.0, 1e-6, 1e-3, 0.4}) {
    EXPECT_NEAR(shape(sphere, x), x * x / 0.02, roundoff * x * x / 0.01);
    EXPECT_NEAR(transform(sphere, x), x * x / 0.01, roundoff * x * x / 0.01);
    EXPECT_NEAR(transform(spike, -x), pi / 2 * x * std::tan(0.1), roundoff * x);
    EXPECT_NEAR(shape_slope(sphere, x), x / 0.01, roundoff * x / 0.01);
    EXPECT_NEAR(transform_slope(spike, x), pi / 2 * std::tan(0.1), roundoff);
  }
}

TEST(Profile, RejectsBadArguments) {
  EXPECT_THROW(parabola(0), std::invalid_argument);
  EXPECT_THROW(parabola(-1), std::invalid_argument);
  EXPECT_THROW(parabola(nan), std::invalid_argument);
  EXPECT_THROW(cone(0), std::invalid_argument);
  EXPECT_THROW(cone(pi / 2), std::invalid_argument);
  EXPECT_THROW(cone(nan), std::invalid_argument);
  EXPECT_THROW(power_law(1, 0.4), std::invalid_argument);
  EXPECT_THROW(power_law(1, 21), std::invalid_argument);
  EXPECT_THROW(power_law(0, 2), std::invalid_argument);
  EXPECT_THROW(shape(parabola(1), -1), std::invalid_argument);
  EXPECT_THROW(transform(parabola(1), nan), std::invalid_argument);
  EXPECT_THROW(inverse_transform(parabola(1), -1e-9), std::invalid_argument);
}

TEST(Profile, MessageNamesQuantityValueAndRange) {
  try {
    power_law(1, 21);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "exponent of the power law = 21: must lie between 0.5 and 20");
  }
}

}  // namespace
}  // namespace fretval::mdr::profile_test
