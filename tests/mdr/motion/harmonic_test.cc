#include "mdr/motion/harmonic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::harmonic_test {
namespace {

// Guarantee of the maximum, for amplitudes of order one.
constexpr double tolerance = 2e-13;

TEST(Supremum, OfCommensurateHarmonicsIsTheMaximum) {
  // cos(theta) - cos(2 theta) = x + 1 - 2 x^2, at most 9/8 at x = cos(theta) = 1/4.
  EXPECT_NEAR(supremum({{1, 3, 0}, {-1, 6, 0}}), 1.125, tolerance);
  EXPECT_NEAR(supremum({{1, 3, 0}, {1, 6, pi}}), 1.125, tolerance);
  EXPECT_NEAR(supremum({{1, 1.0 / 3, 0}, {1, 2.0 / 3, pi}}), 1.125, tolerance);
}

TEST(Supremum, OfIncommensurateHarmonicsIsTheSum) {
  EXPECT_NEAR(supremum({{1, 1, 0.3}, {-0.5, std::sqrt(2.0), 2}}), 1.5, tolerance);
  // Two groups, each with its own maximum.
  const double root = std::sqrt(2.0);
  EXPECT_NEAR(supremum({{1, 1, 0}, {2, root, 0}, {-1, 2, 0}, {-2, 2 * root, 0}}), 3 * 1.125, tolerance);
}

TEST(Supremum, IgnoresHarmonicsThatDoNotMove) {
  EXPECT_EQ(supremum({}), 0);
  // Through 1/97, 1/101 and 1/103 Hz the order of 1 Hz would exceed the bound.
  EXPECT_NEAR(supremum({{0, 1.0 / 97, 0}, {0, 1.0 / 101, 0}, {0, 1.0 / 103, 0}, {1, 1, 0}, {1, 2, pi}}), 1.125,
              tolerance);
}

TEST(Supremum, OfOneHarmonicIsItsSizeWhateverSignAndPhase) {
  for (const double phase : {0.0, 1.0, -2.5, 100.0}) {
    EXPECT_NEAR(supremum({{0.3, 7, phase}}), 0.3, tolerance);
    EXPECT_NEAR(supremum({{-0.3, 7, phase}}), 0.3, tolerance);
  }
}

// cos(theta) + cos(theta + phase) = 2 cos(phase/2) cos(theta + phase/2).
TEST(Supremum, OfTwoOfEqualFrequencyDependsOnTheirPhases) {
  for (const double phase : {0.0, 0.4, 2.0}) {
    EXPECT_NEAR(supremum({{1, 5, 0.2}, {1, 5, 0.2 + phase}}), 2 * std::cos(phase / 2), tolerance);
    EXPECT_NEAR(supremum({{1, 5, 0.2}, {-1, 5, 0.2 + phase}}), 2 * std::sin(phase / 2), tolerance);
  }
}

TEST(Supremum, NamesWhatIsWrong) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double frequency : {0.0, -1.0, nan})
    EXPECT_NE(error_of([&] { supremum({{1, frequency, 0}}); }).find("frequency"), std::string::npos) << frequency;
  EXPECT_NE(error_of([&] { supremum({{nan, 1, 0}}); }).find("finite"), std::string::npos);
  EXPECT_NE(error_of([&] { supremum({{1, 1, nan}}); }).find("finite"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::harmonic_test
