#include "fem/motion/running_minimum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "fem/support/constants.h"
#include "tests/fem/convergence.h"
#include "tests/worse.h"

namespace fretval::fem::running_minimum_test {
namespace {

constexpr double no_floor = -std::numeric_limits<double>::infinity();

// A minimum that is not symmetric, at a place that no sampling hits; -e^x cos x has it at x = pi/4.
double signal(double x) {
  return -std::exp(x) * std::cos(x);
}

double error_of(int n_samples, double shift) {
  RunningMinimum minimum(1, no_floor);
  for (int k = 0; k <= n_samples; ++k)
    minimum.add(Eigen::VectorXd::Constant(1, signal(2 * (k + shift) / n_samples - 0.2)));
  return minimum.value()[0] - signal(pi / 4);
}

// 2.4e-8 at 80 samples, where parabolas are 5.5e-6 off, and the samples alone h^2 |f''| / 8 = 2e-4.
TEST(RunningMinimum, IsOfFifthOrder) {
  std::vector<double> errors;
  for (const int n : {20, 40, 80, 160}) {
    double worst = 0;
    for (const double shift : {0.0, 0.2, 0.4, 0.6, 0.8}) worst = worse(worst, std::abs(error_of(n, shift)));
    errors.push_back(worst);
  }
  EXPECT_GT(observed_order(errors), 4.7);
  EXPECT_LT(errors[2], 1e-7);
}

// cos(x - 0.3) from 20 samples, in both orders.
TEST(RunningMinimum, GivesTheLargestOfAPeriod) {
  const auto samples = [](double begin) {
    return Eigen::VectorXd(Eigen::VectorXd::LinSpaced(20, begin, begin + 2 * pi * 0.95).array().cos());
  };
  EXPECT_NEAR(largest_of_period(samples(-0.3), {}), 1, 1e-5);
  EXPECT_NEAR(largest_of_period(samples(2.9), {}), 1, 1e-5);
  EXPECT_LT(samples(-0.3).maxCoeff(), 1 - 1e-5);
}

TEST(RunningMinimum, IsThatOfAParabolaWhereSamplesAreNotSmooth) {
  // |t - 4.25| around its kink: 1.25, 0.25, 0.75.
  RunningMinimum minimum(1, no_floor);
  for (int k = 0; k < 9; ++k) minimum.add(Eigen::VectorXd::Constant(1, std::abs(k - 4.25)));
  EXPECT_DOUBLE_EQ(minimum.value()[0], 0.25 - 0.25 * 0.25 / (2 * 1.5));
}

TEST(RunningMinimum, IsExactForAParabola) {
  RunningMinimum minimum(2, no_floor);
  for (int k = 0; k < 10; ++k) {
    const double x = 0.3 * k - 1.234;
    minimum.add(Eigen::Vector2d(x * x - 5, 2 * x * x + x));
  }
  EXPECT_NEAR(minimum.value()[0], -5, 1e-14);
  EXPECT_NEAR(minimum.value()[1], -0.125, 1e-14);
}

TEST(RunningMinimum, TakesTheEndsOfAMonotoneSignal) {
  RunningMinimum minimum(2, no_floor);
  for (int k = 0; k < 5; ++k) minimum.add(Eigen::Vector2d(k * k, -k));
  EXPECT_EQ(minimum.value()[0], 0);
  EXPECT_EQ(minimum.value()[1], -4);
}

TEST(RunningMinimum, LeavesAConstantSignalAlone) {
  RunningMinimum minimum(1, no_floor);
  for (int k = 0; k < 5; ++k) minimum.add(Eigen::VectorXd::Constant(1, 0.1));
  EXPECT_EQ(minimum.value()[0], 0.1);
}

TEST(RunningMinimum, KeepsTheLowestOfSeveralMinima) {
  RunningMinimum minimum(1, no_floor);
  for (const double value : {3.0, 1.0, 3.0, 2.0, 3.0, 0.5, 3.0, 1.5}) minimum.add(Eigen::VectorXd::Constant(1, value));
  EXPECT_NEAR(minimum.value()[0], 0.5, 1e-15);
}

TEST(RunningMinimum, IsInfiniteWithoutSamples) {
  EXPECT_EQ(RunningMinimum(1, no_floor).value()[0], std::numeric_limits<double>::infinity());
}

TEST(RunningMinimum, StaysAboveTheFloorAtAKink) {
  // A parabola through 1, 0, 0 would dip to -1/8.
  RunningMinimum minimum(1, 0);
  for (const double value : {1.0, 0.0, 0.0, 1.0}) minimum.add(Eigen::VectorXd::Constant(1, value));
  EXPECT_EQ(minimum.value()[0], 0);
}

TEST(RunningMinimum, SeesAMinimumAcrossARestart) {
  // (t - 2.3)^2 sampled at 0, 1, 2 | 3, 4: the lowest sample 2 belongs to both sides.
  RunningMinimum minimum(1, no_floor);
  const auto add = [&](double t) { minimum.add(Eigen::VectorXd::Constant(1, (t - 2.3) * (t - 2.3))); };
  for (const double t : {0.0, 1.0, 2.0}) add(t);
  minimum.restart();
  for (const double t : {3.0, 4.0}) add(t);
  EXPECT_NEAR(minimum.value()[0], 0, 1e-14);
}

}  // namespace
}  // namespace fretval::fem::running_minimum_test
