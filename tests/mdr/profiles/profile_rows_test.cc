#include "mdr/profiles/profile_rows.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::profile_rows_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

std::string error_of_rows(const std::vector<double>& r, const std::vector<double>& f, std::size_t n_least = 2) {
  return error_of([&] { require_profile_rows(r, f, n_least); });
}

TEST(ProfileRows, MayStartOffTheAxisAndHaveAnyHeights) {
  EXPECT_EQ(error_of_rows({0, 1}, {-1, -2}), "accepted");
  EXPECT_EQ(error_of_rows({0.5, 0.6, 3}, {1, 0, 1}, 3), "accepted");
}

TEST(ProfileRows, MustBeAsManyOfBothAndEnough) {
  EXPECT_EQ(error_of_rows({0, 1, 2}, {0, 1}),
            "profile table of 3 radii and 2 heights: expected as many of both, and at least 2");
  EXPECT_EQ(error_of_rows({0, 1}, {0, 1}, 3),
            "profile table of 2 radii and 2 heights: expected as many of both, and at least 3");
  EXPECT_NE(error_of_rows({}, {}), "accepted");
}

TEST(ProfileRows, BadOnesAreNamedCountedFromOne) {
  EXPECT_EQ(error_of_rows({-1, 1}, {0, 1}),
            "radius in row 1 of the profile table = -1: must be finite and not negative");
  EXPECT_EQ(error_of_rows({0, 1, 1}, {0, 1, 2}),
            "radius in row 3 of the profile table = 1: must be greater than the one before");
  EXPECT_EQ(error_of_rows({0, 2, 1}, {0, 1, 2}),
            "radius in row 3 of the profile table = 1: must be greater than the one before");
  EXPECT_EQ(error_of_rows({0, 1}, {0, nan}), "height in row 2 of the profile table = nan: must be finite");
  EXPECT_EQ(error_of_rows({0, 1}, {-infinity, 0}), "height in row 1 of the profile table = -inf: must be finite");
  EXPECT_NE(error_of_rows({0, infinity}, {0, 1}).find("radius in row 2"), std::string::npos);
  EXPECT_NE(error_of_rows({0, nan}, {0, 1}).find("radius in row 2"), std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::profile_rows_test
