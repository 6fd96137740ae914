#include "mdr/profiles/trace_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "mdr/profiles/profile.h"

namespace fretval::mdr::trace_alignment_test {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

struct Trace {
  std::vector<double> x, z;
};

struct Stage {
  double apex = 0.14e-3, tilt = 0.2 * degree, noise = 20e-9, half_width = 1e-3, sign = -1;
  int n_rows = 4001;
  unsigned seed = 1;
};

Trace trace_of(const std::function<double(double)>& height, const Stage& stage) {
  std::mt19937 engine(stage.seed);
  std::normal_distribution<double> scatter(0, stage.noise);
  Trace trace;
  for (int i = 0; i < stage.n_rows; ++i) {
    const double x = stage.half_width * (2.0 * i / (stage.n_rows - 1) - 1), u = x - stage.apex;
    trace.x.push_back(x);
    trace.z.push_back(3e-6 + stage.sign * height(std::abs(u)) + stage.tilt * u + scatter(engine));
  }
  return trace;
}

double sphere_of_5_mm(double r) {
  constexpr double R = 5e-3;
  return R - std::sqrt(R * R - r * r);
}

TEST(TraceAlignment, FindsApexTiltAndSignOfASphere) {
  for (const unsigned seed : {1, 2, 3, 4, 5}) {
    Stage stage;
    stage.seed = seed;
    const auto [x, z] = trace_of(sphere_of_5_mm, stage);
    const auto found = align_trace(x, z);
    EXPECT_TRUE(found.heights_upwards);
    EXPECT_NEAR(found.noise, stage.noise, 0.05 * stage.noise);
    // Three standard deviations, which themselves are good to some tens of percent.
    EXPECT_NEAR(found.apex, stage.apex, 4 * found.apex_uncertainty);
    EXPECT_NEAR(found.tilt, stage.tilt, 4 * found.tilt_uncertainty);
    EXPECT_LT(found.apex_uncertainty, 10e-6);
  }
}

TEST(TraceAlignment, OfAConeHasASharpApex) {
  Stage stage;
  stage.sign = 1;
  const auto [x, z] = trace_of([](double r) { return 0.05 * r; }, stage);
  const auto found = align_trace(x, z);
  EXPECT_FALSE(found.heights_upwards);
  EXPECT_NEAR(found.apex, stage.apex, 4 * found.apex_uncertainty);
  EXPECT_NEAR(found.tilt, stage.tilt, 4 * found.tilt_uncertainty);
  EXPECT_LT(found.apex_uncertainty, 1e-6);
}

TEST(TraceAlignment, OfAParabolaLeavesTheApexOpenButNotTheProfile) {
  constexpr double R = 5e-3;
  const Stage stage;
  const auto [x, z] = trace_of([](double r) { return r * r / (2 * R); }, stage);
  const auto found = align_trace(x, z);
  EXPECT_NEAR(found.apex, stage.apex, 3 * found.apex_uncertainty);
  EXPECT_GT(found.apex_uncertainty, 50e-6);
  for (const auto& one : neighbours_of(found, x, z)) {
    const auto [r, f, noise] = aligned_profile(one, x, z);
    const auto profile = tabulated(r, f, noise);
    const double depth = 20e-6, a = std::sqrt(R * depth);
    EXPECT_NEAR(inverse_transform(profile, depth), a, 1e-3 * a);
  }
}

TEST(TraceAlignment, ProfileIsThatOfTheBody) {
  const auto [x, z] = trace_of(sphere_of_5_mm, {});
  const auto found = align_trace(x, z);
  const auto [r, f, noise] = aligned_profile(found, x, z);
  // Within 0.86 mm of the apex are 3440 rows, 17 to each of 200 means.
  EXPECT_NEAR(noise, 20e-9 / std::sqrt(17), 0.5e-9);
  const auto aligned = tabulated(r, f, noise);
  const auto exact = sphere(5e-3);
  for (const double depth : {10e-6, 30e-6})
    EXPECT_NEAR(inverse_transform(aligned, depth) / inverse_transform(exact, depth), 1, 1e-3);
}

TEST(TraceAlignment, RefusesWhatItCannotAlign) {
  Stage stage;
  stage.apex = 0.9e-3;
  const auto [x, z] = trace_of(sphere_of_5_mm, stage);
  EXPECT_THROW(align_trace(x, z), std::invalid_argument);
  EXPECT_THROW(align_trace({0, 1, 2}, {0, 1, 2}), std::invalid_argument);
  auto twice = x;
  twice[5] = twice[4];
  EXPECT_THROW(align_trace(twice, z), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::trace_alignment_test
