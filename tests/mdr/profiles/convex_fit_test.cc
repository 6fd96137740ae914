#include "mdr/profiles/convex_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "mdr/profiles/indentation.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "tests/worse.h"

namespace fretval::mdr::convex_fit_test {
namespace {

struct Scan {
  std::vector<double> r, f;
};

using Heights = std::function<double(double)>;

// Heights with Gaussian noise and an offset at uneven rows from first to 1.
Scan scan(int n, const Heights& height, double noise, unsigned seed, double first = 0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.1, 2);
  std::normal_distribution<double> scatter(0, noise);
  Scan rows{{0}, {}};
  for (int k = 1; k < n; ++k) rows.r.push_back(rows.r.back() + step(random));
  const double length = rows.r.back();
  for (double& r : rows.r) {
    r = first + (1 - first) * (r / length);
    rows.f.push_back(height(r) + scatter(random) + 0.7);
  }
  return rows;
}

Heights heights_of(const Profile& profile) {
  return [profile](double r) { return shape(profile, r); };
}

Scan scan(int n, const Profile& profile, double noise, unsigned seed, double first = 0) {
  return scan(n, heights_of(profile), noise, seed, first);
}

struct Errors {
  double image, radius, force;  // rms over seeds, relative
};

Errors errors(const Profile& exact, int n, double noise, double depth_at, int n_seeds) {
  Errors sum{0, 0, 0};
  const double d = transform(exact, depth_at);
  const auto add = [&](double& square, double ratio) { square += (ratio - 1) * (ratio - 1) / n_seeds; };
  for (int seed = 0; seed < n_seeds; ++seed) {
    const Scan rows = scan(n, exact, noise, static_cast<unsigned>(seed));
    const Profile fitted = tabulated(rows.r, rows.f, noise);
    add(sum.image, transform(fitted, depth_at) / d);
    add(sum.radius, contact_radius(fitted, d) / depth_at);
    add(sum.force, normal_force(fitted, 1, d) / normal_force(exact, 1, d));
  }
  return {std::sqrt(sum.image), std::sqrt(sum.radius), std::sqrt(sum.force)};
}

std::string refusal(const Scan& rows, double noise) {
  try {
    convex_fit(rows.r, rows.f, noise);
    return "accepted";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

double named_radius(const std::string& message) {
  return std::stod(message.substr(message.find('=') + 1));
}

// The four parameters of a fit without inner knots are determined to noise/sqrt(n) each; for g at 0.8 of the last row,
// a factor of order 5 between them. The rms of 40 seeds has a standard error of 11 %.
TEST(ConvexFit, ErrorsOfAParabolaFallWithTheRootOfTheRows) {
  const double noise = 1e-3 * 0.25;
  Errors before{0, 0, 0};
  for (const int n : {50, 500, 5000}) {
    const Errors here = errors(parabola(2), n, noise, 0.8, 40);
    const double expected = 1e-3 / std::sqrt(n);
    for (const double error : {here.image, here.radius, here.force}) EXPECT_LT(error, 5 * expected) << n;
    if (n > 50) {
      EXPECT_NEAR(before.image / here.image, std::sqrt(10), 1.2);
      EXPECT_NEAR(before.radius / here.radius, std::sqrt(10), 1.2);
      EXPECT_NEAR(before.force / here.force, std::sqrt(10), 1.2);
    }
    before = here;
  }
}

// Where knots are added, bias as large as the scatter of a few parameters stays unseen.
TEST(ConvexFit, OtherShapesAreMetWithinTheNoise) {
  const double tan = std::tan(0.3);
  for (const Profile& exact : {cone(0.3), truncated_sphere(3, 0.4), rounded_flat(0.4, 2), power_law(0.3, 3.4)}) {
    const double noise = 1e-3 * shape(exact, 1);
    const Errors few = errors(exact, 100, noise, 0.8, 10), many = errors(exact, 5000, noise, 0.8, 10);
    for (const double error : {few.image, few.radius, few.force}) EXPECT_LT(error, 2e-3);
    for (const double error : {many.image, many.radius, many.force}) EXPECT_LT(error, 2.5e-4);
  }
  const Scan rows = scan(500, cone(0.3), 1e-4, 5);
  EXPECT_NEAR(convex_fit(rows.r, rows.f, 1e-4).height.coefficients[0][1], tan, 1e-4);
}

TEST(ConvexFit, ReportsTheResiduals) {
  const double noise = 1e-4;
  Scan rows = scan(2000, parabola(2), noise, 3);
  const ConvexFit fit = convex_fit(rows.r, rows.f, noise);
  EXPECT_NEAR(fit.residual_rms / noise, 1, 0.05);  // 3/sqrt(2 n)
  EXPECT_NEAR(fit.offset, 0.7, 4 * noise / std::sqrt(2000) * 3);
  double rms = 0, worst = 0;
  for (std::size_t k = 0; k < rows.r.size(); ++k) {
    const double residual = rows.f[k] - fit.offset - value(fit.height, rows.r[k]);
    rms += residual * residual / 2000;
    worst = worse(worst, std::abs(residual));
    if (rows.r[k] == fit.worst_radius) {
      EXPECT_NEAR(residual, fit.worst_residual, 1e-13);
    }
  }
  EXPECT_NEAR(std::sqrt(rms), fit.residual_rms, 1e-12);
  EXPECT_NEAR(worst, std::abs(fit.worst_residual), 1e-13);
}

// Zero and first derivatives at the knots, and f'' >= 0.
TEST(ConvexFit, IsConvexAndTwiceDifferentiable) {
  const Scan rows = scan(500, truncated_sphere(3, 0.4), 1e-4, 3);
  const PiecewiseCubic height = convex_fit(rows.r, rows.f, 1e-4).height;
  const PiecewiseCubic slope = derivative(height), curvature = derivative(slope);
  ASSERT_GT(height.nodes.size(), 5);
  EXPECT_EQ(value(height, 0), 0);
  EXPECT_GE(value(slope, 0), 0);
  for (const double node : height.nodes) EXPECT_GE(value(curvature, node), -1e-13);
  for (std::size_t k = 1; k + 1 < height.nodes.size(); ++k) {
    const double h = height.nodes[k] - height.nodes[k - 1];
    const auto at_end = [h](const std::array<double, 4>& c) { return c[0] + h * (c[1] + h * (c[2] + h * c[3])); };
    EXPECT_NEAR(at_end(height.coefficients[k - 1]), height.coefficients[k][0], 1e-14);
    EXPECT_NEAR(at_end(slope.coefficients[k - 1]), slope.coefficients[k][0], 1e-13);
    EXPECT_NEAR(at_end(curvature.coefficients[k - 1]), curvature.coefficients[k][0],
                1e-12 * (1 + curvature.coefficients[k][0]));
  }
}

// A tip that could be horizontal is: else the pressure on the axis were infinite.
TEST(ConvexFit, TheTipOfAParabolaIsHorizontal) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Scan rows = scan(200, parabola(2), 1e-3, seed);
    EXPECT_EQ(convex_fit(rows.r, rows.f, 1e-3).height.coefficients[0][1], 0);
    EXPECT_TRUE(std::isfinite(pressure(tabulated(rows.r, rows.f, 1e-3), 1, 0.2, 0)));
  }
}

// Where a single straight f'' does not do, knots make the tip horizontal, not a slope of next to nothing.
TEST(ConvexFit, TheTipOfASphereIsHorizontal) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Scan rows = scan(1200, sphere(4), 4e-6, seed);
    EXPECT_EQ(convex_fit(rows.r, rows.f, 4e-6).height.coefficients[0][1], 0) << seed;
  }
}

TEST(ConvexFit, AScanMayStartOffTheAxis) {
  const Scan rows = scan(500, parabola(2), 1e-4, 4, 0.07);
  ASSERT_GT(rows.r[0], 0.069);
  const Profile fitted = tabulated(rows.r, rows.f, 1e-4);
  EXPECT_NEAR(transform(fitted, 0.5) / transform(parabola(2), 0.5), 1, 1e-3);
  EXPECT_THROW(tabulated(rows.r, rows.f), std::invalid_argument);
}

TEST(ConvexFit, RefusesADimpleAndABumpWhereTheyAre) {
  for (const double height : {-2e-3, 2e-3}) {
    const Heights uneven = [height](double r) { return r * r / 4 + height * std::exp(-std::pow((r - 0.6) / 0.03, 2)); };
    for (const int n : {300, 5000}) {
      const std::string message = refusal(scan(n, uneven, 1e-4, 1), 1e-4);
      ASSERT_NE(message.find("not those of a convex profile"), std::string::npos) << message;
      EXPECT_NEAR(named_radius(message), 0.6, 0.06) << message;
      EXPECT_NE(message.find(height < 0 ? "m below it" : "m above it"), std::string::npos) << message;
    }
    // Under ten times the noise they are not to be seen.
    EXPECT_EQ(refusal(scan(300, uneven, 2e-2, 1), 2e-2), "accepted");
  }
}

TEST(ConvexFit, RefusesNoiseStatedTooSmallWithWhatItIs) {
  for (const int n : {50, 500, 5000}) {
    const std::string message = refusal(scan(n, parabola(2), 1e-3, 2), 1e-4);
    ASSERT_NE(message.find("stated noise of 0.0001 m"), std::string::npos) << message;
    const double rms = std::stod(message.substr(message.find("residuals of ") + 13));
    EXPECT_NEAR(rms, 1e-3, 5e-4) << message;  // 50 rows: the wiggles take up some of it
  }
}

TEST(ConvexFit, RefusesASingleRowFarOff) {
  Scan rows = scan(500, parabola(2), 1e-4, 6);
  rows.f[200] += 2e-3;
  const std::string message = refusal(rows, 1e-4);
  EXPECT_NEAR(named_radius(message), rows.r[200], 1e-3) << message;
}

TEST(ConvexFit, RarelyRefusesPureNoiseOrAddsKnotsToIt) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Scan rows = scan(seed % 2 == 0 ? 40 : 400, parabola(2), 1e-3, seed);
    EXPECT_EQ(convex_fit(rows.r, rows.f, 1e-3).height.nodes.size(), 2) << seed;
  }
}

TEST(ConvexFit, DoesNotDependOnUnits) {
  const Scan rows = scan(300, truncated_sphere(3, 0.4), 1e-4, 8);
  const double metre = 3.7e-9, height = 2.3e5;
  Scan other = rows;
  for (double& r : other.r) r *= metre;
  for (double& f : other.f) f *= height;
  const Profile here = tabulated(rows.r, rows.f, 1e-4), there = tabulated(other.r, other.f, 1e-4 * height);
  // Roundoff times the condition of the least squares with knots around the kink.
  for (const double x : {0.1, 0.45, 0.9})
    EXPECT_NEAR(transform(there, x * metre) / height, transform(here, x), 1e-10 * transform(here, 0.9));
}

// What the fit gives serves as any other profile.
TEST(ConvexFit, WearsLikeTheExactProfile) {
  const Scan rows = scan(2000, parabola(2), 1e-5, 10);
  const LimitingProfile fitted = limiting_profile(tabulated(rows.r, rows.f, 1e-5), 0.3, 0.2);
  const LimitingProfile exact = limiting_profile(parabola(2), 0.3, 0.2);
  EXPECT_NEAR(fitted.outer_radius, exact.outer_radius, 1e-4);
  EXPECT_NEAR(worn_depth(fitted, 0.5), worn_depth(exact, 0.5), 1e-5);
}

TEST(ConvexFit, NamesWhatIsWrong) {
  const Scan rows = scan(20, parabola(2), 1e-3, 1);
  EXPECT_NE(refusal({{0, 1, 2, 3}, {0, 1, 4, 9}}, 1e-3).find("at least 8"), std::string::npos);
  EXPECT_NE(refusal(rows, 0).find("noise of the profile table in m = 0"), std::string::npos);
  EXPECT_NE(refusal(rows, NAN).find("noise"), std::string::npos);
  EXPECT_THROW(tabulated(rows.r, rows.f, -1e-3), std::invalid_argument);
  Scan bad = rows;
  bad.r[7] = bad.r[6];
  EXPECT_NE(refusal(bad, 1e-3).find("in row 8"), std::string::npos);
  bad = rows;
  bad.f[7] = INFINITY;
  EXPECT_NE(refusal(bad, 1e-3).find("height in row 8"), std::string::npos);
  const Scan flat = scan(
      50, [](double) { return 0.0; }, 1e-3, 1);
  EXPECT_THROW(tabulated(flat.r, std::vector<double>(50, 0.1), 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::convex_fit_test
