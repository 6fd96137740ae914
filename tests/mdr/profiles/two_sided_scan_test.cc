#include "mdr/profiles/two_sided_scan.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::two_sided_scan_test {
namespace {

using Numbers = std::vector<double>;

TEST(TwoSidedScan, EqualHalvesAreTheProfile) {
  const auto mean = mean_of_halves({-3, -1, 0, 1, 3}, {9, 1, 0, 1, 9});
  EXPECT_EQ(mean.r, (Numbers{0, 1, 3}));
  EXPECT_EQ(mean.f, (Numbers{0, 1, 9}));
  EXPECT_EQ(mean.largest_difference, 0);
  EXPECT_EQ(mean.range(), 9);
}

// Left: (0, 1), (2, 5), (4, 13). Right: (0, 1), (1, 2), (3, 8), (5, 30). Both are linear between.
TEST(TwoSidedScan, MeanStandsAtTheRadiiOfEitherHalfUpToTheShorterOne) {
  const auto mean = mean_of_halves({-4, -2, 0, 1, 3, 5}, {13, 5, 1, 2, 8, 30});
  EXPECT_EQ(mean.r, (Numbers{0, 1, 2, 3, 4}));
  EXPECT_EQ(mean.f, (Numbers{1, 2.5, 5, 8.5, 16}));
  EXPECT_EQ(mean.largest_difference, 6);
  EXPECT_EQ(mean.radius_of_difference, 4);
}

// Without a row at the apex the mean begins where both halves do.
TEST(TwoSidedScan, BeginsWhereBothHalvesDo) {
  const auto mean = mean_of_halves({-3, -1, 2, 4}, {3, 1, 2, 4});
  EXPECT_EQ(mean.r, (Numbers{2, 3}));
  EXPECT_EQ(mean.f, (Numbers{2, 3}));
}

TEST(TwoSidedScan, RadiiWithinRoundoffAreOne) {
  EXPECT_EQ(mean_of_halves({-2, -0.3, 0, 0.3 + 1e-16, 2}, {2, 0.3, 0, 0.3, 2}).r.size(), 3U);
  EXPECT_EQ(mean_of_halves({-2, -0.3, 0, 0.3 + 1e-8, 2}, {2, 0.3, 0, 0.3, 2}).r.size(), 4U);
}

// Halves that rise to 99 and 101 differ by 2 % of their range, those to 97 and 103 by 6 %.
TEST(TwoSidedScan, RefusesHalvesThatDifferByMoreThanFivePercent) {
  const auto scan = [](double left, double right) { return mean_of_halves({-2, 0, 2}, {left, 0, right}); };
  EXPECT_NO_THROW(require_axisymmetric(scan(99, 101), 0));
  EXPECT_NO_THROW(require_axisymmetric(scan(97.6, 102.4), 0));
  const auto message = error_of([&] { require_axisymmetric(scan(97, 103), 0); });
  for (const char* part : {"differ by 6 m at r = 2 m", "6 % of the range", "at most 5 %", "apex?"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  // A noise of 0.2 m explains 1.2 m of them.
  EXPECT_NO_THROW(require_axisymmetric(scan(97, 103), 0.2));
  EXPECT_THROW(require_axisymmetric(scan(97, 103), 0.1), std::invalid_argument);
}

TEST(TwoSidedScan, RefusesHalvesThatDoNotMeet) {
  EXPECT_NE(error_of([] {
              mean_of_halves({-1, 1, 2}, {1, 1, 4});
            }).find("r <= 0 = 1: must be at least 2"),
            std::string::npos);
  EXPECT_NE(error_of([] {
              mean_of_halves({-2, -1, 3, 4}, {1, 1, 4, 5});
            }).find("= 3: must be inside the last one"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::two_sided_scan_test
