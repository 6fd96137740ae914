#include "mdr/springs/sampled_peak.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace fretval::mdr::sampled_peak_test {
namespace {

// Between samples, also across the ends of the period. Of a parabola through a cosine: (x dt)^4/24 at most.
TEST(SampledPeak, IsTheOneBetweenTheSamples) {
  constexpr int n = 36;
  const double dt = 2 * std::acos(-1.0) / n;
  for (const double phase : {0.0, 0.3 * dt, 0.5 * dt, 1.0, 3.0}) {
    std::vector<double> samples;
    for (int k = 0; k <= n; ++k) samples.push_back(5 + 2 * std::cos(k * dt + phase));
    EXPECT_NEAR(sampled_peak(samples, 1), 7, 2 * std::pow(dt, 4) / 24) << phase;
    EXPECT_NEAR(sampled_peak(samples, -1), 3, 2 * std::pow(dt, 4) / 24) << phase;
  }
}

// A contact that slides at 1, and turns within a step.
TEST(SampledPeak, OfFrictionIsNotBeyondItsLimit) {
  const std::vector<double> pull{-1, 1, 1, 1, -1, -1, -1}, constant(7, 2.0);
  EXPECT_GT(sampled_peak(pull, 1), 1.05);
  EXPECT_EQ(friction_peak(pull, constant, 0.5), 1);
  EXPECT_EQ(friction_peak(pull, constant, 0.4), 1) << "samples stand";
  const std::vector<double> rising{2, 2.04, 2, 2, 2, 2, 2};
  EXPECT_NEAR(friction_peak(pull, rising, 0.5), 1.02, 1e-15) << "the normal force beside the sample";
  const std::vector<double> sticks{0, 0.8, 0.9, 0.8, 0, -0.5, 0};
  EXPECT_EQ(friction_peak(sticks, constant, 0.5), sampled_peak(sticks, 1));
}

// A contact that slides while its normal force is largest, between two samples.
TEST(SampledPeak, OfFrictionThatSlidesIsMuTimesThatOfTheNormalForce) {
  constexpr int n = 36;
  const double dt = 2 * std::acos(-1.0) / n, mu = 0.3;
  std::vector<double> normal, pull;
  for (int k = 0; k <= n; ++k) {
    normal.push_back(5 + 2 * std::cos(k * dt - 1.1));
    pull.push_back(std::cos(k * dt) > 0 ? mu * normal.back() : -mu);
  }
  EXPECT_NEAR(friction_peak(pull, normal, mu), mu * sampled_peak(normal, 1), 1e-15);
  EXPECT_LT(*std::max_element(pull.begin(), pull.end()), mu * 6.999);
}

TEST(SampledPeak, OfAConstantIsTheConstant) {
  EXPECT_EQ(sampled_peak({2, 2, 2, 2}, 1), 2);
}

}  // namespace
}  // namespace fretval::mdr::sampled_peak_test
