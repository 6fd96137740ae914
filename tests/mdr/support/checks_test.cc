#include "mdr/support/checks.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::checks_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity(),
             smallest = std::numeric_limits<double>::denorm_min();

TEST(Checks, PositiveExcludesZero) {
  EXPECT_NO_THROW(require_positive("radius", smallest));
  for (const double value : {0.0, -1.0, infinity, nan})
    EXPECT_THROW(require_positive("radius", value), std::invalid_argument) << value;
}

TEST(Checks, NonNegativeIncludesZero) {
  EXPECT_NO_THROW(require_non_negative("radius", 0));
  EXPECT_NO_THROW(require_non_negative("radius", -0.0));
  for (const double value : {-smallest, infinity, nan})
    EXPECT_THROW(require_non_negative("radius", value), std::invalid_argument) << value;
}

TEST(Checks, WithinIncludesBothBoundsButNoInfinity) {
  EXPECT_NO_THROW(require_within("exponent", 0.5, 0.5, 20));
  EXPECT_NO_THROW(require_within("exponent", 20, 0.5, 20));
  for (const double value : {0.499, 20.001, -infinity, nan})
    EXPECT_THROW(require_within("exponent", value, 0.5, 20), std::invalid_argument) << value;
  EXPECT_THROW(require_within("exponent", infinity, 0, infinity), std::invalid_argument);
}

TEST(Checks, FiniteTakesAnySign) {
  EXPECT_NO_THROW(require_finite("phase", -1e308));
  for (const double value : {infinity, -infinity, nan})
    EXPECT_THROW(require_finite("phase", value), std::invalid_argument) << value;
}

TEST(Checks, MessagesNameQuantityValueAndWhatWouldBeValid) {
  EXPECT_EQ(error_of([] { require_positive("radius", -0.25); }), "radius = -0.25: must be finite and positive");
  EXPECT_EQ(error_of([] { require_non_negative("noise", nan); }), "noise = nan: must be finite and not negative");
  EXPECT_EQ(error_of([] { require_within("exponent", 21, 0.5, 20); }), "exponent = 21: must lie between 0.5 and 20");
  EXPECT_EQ(error_of([] { require_finite("phase", infinity); }), "phase = inf: must be finite");
  // Digits enough to see by how little a value is off.
  EXPECT_EQ(error_of([] { reject("r", 1.00000000000001, "must be 1"); }), "r = 1.00000000000001: must be 1");
}

}  // namespace
}  // namespace fretval::mdr::checks_test
