#include "mdr/profiles/profile_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::profile_table_test {
namespace {

std::vector<double> uniform(std::size_t n, double end) {
  std::vector<double> x;
  for (std::size_t k = 0; k <= n; ++k) x.push_back(end * static_cast<double>(k) / static_cast<double>(n));
  return x;
}

std::vector<double> heights(const Profile& profile, const std::vector<double>& r) {
  std::vector<double> f;
  f.reserve(r.size());
  for (const double radius : r) f.push_back(shape(profile, radius));
  return f;
}

// Uneven rows, denser in the middle.
std::vector<double> uneven(std::size_t n, double end) {
  std::vector<double> x = uniform(n, 1);
  for (double& t : x) t = end * (t + 0.1 * std::sin(2 * pi * t));
  return x;
}

TEST(ProfileTable, OfAPowerLawHasItsTransformPressureAndForce) {
  const Profile exact = parabola(2);
  for (const auto& r : {uniform(20, 1), uneven(35, 1)}) {
    const Profile table = tabulated(r, heights(exact, r));
    // Quadratics are interpolated exactly, so are their transforms.
    for (const double x : {1e-3, 0.3, 0.77, 1.0}) {
      EXPECT_NEAR(transform(table, x), transform(exact, x), 1e-13);
      EXPECT_NEAR(transform_slope(table, x), transform_slope(exact, x), 1e-11);
      EXPECT_NEAR(transform_integral(table, x), transform_integral(exact, x), 1e-13);
      EXPECT_NEAR(inverse_transform(table, transform(exact, x)), x, 1e-12);
    }
    for (const double s : {0.0, 0.31, 0.69})
      EXPECT_NEAR(pressure(table, 1, 0.25, s), pressure(exact, 1, 0.25, s), 1e-12);
    EXPECT_NEAR(worn_depth(limiting_profile(table, 0.3, 0.2), 0.5), worn_depth(limiting_profile(exact, 0.3, 0.2), 0.5),
                1e-13);
  }
}

// Straight rows are a cone, g = (pi/2) slope x, whatever height the tip has.
TEST(ProfileTable, OfAConeIsExactAboveItsTip) {
  const ProfileTable table = profile_table({0, 0.3, 1, 2}, {5, 5.06, 5.2, 5.4});
  EXPECT_EQ(end_radius(table), 2);
  EXPECT_EQ(shape(table, 0), 0);
  for (const double x : {0.1, 0.3, 1.7}) {
    EXPECT_NEAR(shape(table, x), 0.2 * x, 1e-15);
    EXPECT_NEAR(shape_slope(table, x), 0.2, 1e-14);
    EXPECT_NEAR(transform(table, -x), pi / 2 * 0.2 * x, 1e-14);
    EXPECT_NEAR(transform_integral(table, x), pi / 2 * 0.1 * x * x, 1e-14);
    EXPECT_NEAR(inverse_transform(table, pi / 2 * 0.2 * x), x, 1e-13);
  }
  EXPECT_NEAR(abel_slope_integral(table, 0.6, 1), pi / 2 * 0.2 * std::log(3), 1e-13);  // arcosh(1/0.6)
  EXPECT_NEAR(abel_depth_integral(table, 0.28, 0.6, 1), pi / 2 * 0.2 * (0.96 - 0.8), 1e-13);
}

TEST(ProfileTable, ConvergesForOtherShapes) {
  const Profile exact = power_law(0.3, 3.4);
  double before = 0;
  for (const std::size_t n : {25, 50, 100, 200}) {
    const auto r = uniform(n, 1);
    const double error = std::abs(transform(tabulated(r, heights(exact, r)), 0.77) / transform(exact, 0.77) - 1);
    // The slopes of three-point parabolas are of second order.
    if (before > 0) {
      EXPECT_GT(before / error, 3.2) << n;
    }
    before = error;
  }
  EXPECT_LT(before, 3e-5);
}

TEST(ProfileTable, RoundTripOfSmoothAndNoisyTables) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  for (const double amplitude : {0.0, 2e-5}) {
    const auto r = uneven(120, 1);
    auto f = heights(parabola(2), r);
    for (std::size_t k = 0; k < f.size(); ++k) f[k] += amplitude * r[k] * noise(random);
    const Profile table = tabulated(r, f);
    for (const double x : {0.05, 0.333, 0.9}) {
      const double back = 2 / pi * abel_depth_integral(table, 0, x, x);  // paper (4)
      EXPECT_NEAR(back / shape(table, x), 1, amplitude > 0 ? 1e-6 : 1e-14) << amplitude << " at " << x;
    }
  }
}

TEST(ProfileTable, FlatFaceAndKinkAreMet) {
  const double b = 0.4;  // flat radius
  const Profile exact = truncated_sphere(3, b);
  auto r = uniform(400, 1);
  const Profile table = tabulated(r, heights(exact, r));
  EXPECT_NEAR(inverse_transform(table, 0), b, 1e-12);
  EXPECT_NEAR(normal_force(table, 1, 0.1) / normal_force(exact, 1, 0.1), 1, 1e-4);
}

void expect_refusal(const std::vector<double>& r, const std::vector<double>& f, const std::string& words) {
  try {
    tabulated(r, f);
    FAIL() << words;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(ProfileTable, NamesWhatIsWrong) {
  expect_refusal({0, 1, 2}, {0, 1, 2}, "at least 4");
  expect_refusal({0, 1, 2, 3}, {0, 1, 2}, "3 heights");
  expect_refusal({0.1, 1, 2, 3}, {0, 1, 2, 3}, "first radius");
  expect_refusal({0, 1, 1, 3}, {0, 1, 2, 3}, "in row 3");
  expect_refusal({0, 1, 2, 3}, {0, 1, NAN, 3}, "in row 3");
  expect_refusal({0, 1, 2, 3}, {0, -1, -2, -3}, "largest slope");
  // A dip at r = 2: the image falls there.
  expect_refusal({0, 1, 1.9, 2, 2.1, 3}, {0, 1, 3, 1, 3.2, 9}, "would not be a full circle");
  const Profile table = tabulated({0, 1, 2, 3}, {0, 1, 4, 9});
  EXPECT_THROW(shape(table, 3.1), std::invalid_argument);
  EXPECT_THROW(inverse_transform(table, 20), std::invalid_argument);
  EXPECT_THROW(limiting_profile(table, 2, 17), std::invalid_argument);
  EXPECT_EQ(end_radius(table), 3);
}

// Hermite cubics would dip before the kink, where straight lines meet it from either side or both.
TEST(ProfileTable, ConvexRowsWithAKinkAreAccepted) {
  for (const double bend : {0.0, 0.3, 1.0}) {
    for (const double kink : {0.3, 0.5, 0.51}) {
      const auto f = [=](double r) {
        return 0.2 * r + bend * r * r / 2 + std::max(0.0, r - kink) + (bend == 0.3 ? 0 : std::pow(r, 4));
      };
      const auto r = uniform(50, 1);
      std::vector<double> rows;
      rows.reserve(r.size());
      for (const double radius : r) rows.push_back(f(radius));
      const Profile table = tabulated(r, rows);
      double slope_before = 0;
      for (int k = 1; k < 997; ++k) {
        const double slope = (shape(table, k / 997.0) - shape(table, (k - 1) / 997.0)) * 997;
        EXPECT_GE(slope, slope_before - 3e-3) << k;  // the narrow bend of a kink between straight lines
        slope_before = slope;
      }
      for (std::size_t k = 0; k < r.size(); ++k) EXPECT_NEAR(shape(table, r[k]), rows[k], 1e-14);
    }
  }
}

// A profile that is concave in places is no obstacle as long as its image rises.
TEST(ProfileTable, ConcaveFlankIsAllowed) {
  const auto r = uniform(60, 1);
  EXPECT_NO_THROW(tabulated(r, heights(power_law(1, 0.8), r)));
}

}  // namespace
}  // namespace fretval::mdr::profile_table_test
