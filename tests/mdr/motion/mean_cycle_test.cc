#include "mdr/motion/mean_cycle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace fretval::mdr::mean_cycle_test {
namespace {

constexpr double two_pi = 6.283185307179586;

struct Rig {
  double period = 1.37, duration = 20.9, rows_per_second = 1000, noise = 0.002, amplitude_scatter = 0, approach = 0;
};

/// d = 1 + 0.2 cos, u = 0.5 cos(2 phase + 0.3), after an approach from -1.
Record record_of(const Rig& rig) {
  std::mt19937 engine(3);
  std::normal_distribution<double> scatter(0, 1);
  Record record;
  double factor = 1;
  int cycle = 0;
  for (int i = 0; i / rig.rows_per_second < rig.duration + rig.approach; ++i) {
    const double t = i / rig.rows_per_second - rig.approach, phase = two_pi * t / rig.period;
    if (t > cycle * rig.period) {
      ++cycle;
      factor = 1 + rig.amplitude_scatter * scatter(engine);
    }
    record.time.push_back(t);
    record.normal.push_back((t < 0 ? 1.2 + 2.2 * t / rig.approach : 1 + 0.2 * std::cos(phase)) +
                            rig.noise * scatter(engine));
    record.tangential.push_back((t < 0 ? 0 : factor * 0.5 * std::cos(2 * phase + 0.3)) + rig.noise * scatter(engine));
  }
  return record;
}

/// Amplitude of the k-th cosine of a cycle, by trapezoids.
double amplitude_of(const Record& cycle, const std::vector<double>& values, int k) {
  double real = 0, imaginary = 0;
  const double period = cycle.time.back();
  for (std::size_t i = 1; i < cycle.time.size(); ++i) {
    const double step = cycle.time[i] - cycle.time[i - 1];
    for (const std::size_t j : {i - 1, i}) {
      real += step / period * values[j] * std::cos(k * two_pi * cycle.time[j] / period);
      imaginary += step / period * values[j] * std::sin(k * two_pi * cycle.time[j] / period);
    }
  }
  return std::hypot(real, imaginary);
}

TEST(MeanCycle, IsTheCycleOfARecordThatNeverCloses) {
  const auto mean = mean_cycle(record_of({}));
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->n_cycles, 15U);
  EXPECT_NEAR(mean->period(), 1.37, 2e-4);
  EXPECT_EQ(mean->cycle.normal.front(), mean->cycle.normal.back());
  // Noise of a mean over 15 cycles of 1370 rows is 1e-5; 240 parts take (2 pi/120)^2/24 off the second harmonic.
  EXPECT_NEAR(amplitude_of(mean->cycle, mean->cycle.normal, 1), 0.2, 1e-4);
  EXPECT_NEAR(amplitude_of(mean->cycle, mean->cycle.tangential, 2), 0.5, 4e-4);
}

// The instants at which cosines of amplitudes 0.2 and, twice as fast, 0.5 are read out of noise of 0.002 fix the period
// to 0.002 sqrt(24 / n) P / (2 pi N sqrt(0.2^2 + 1)) or 5e-7; a drift by more would show as scatter of the cycles.
TEST(MeanCycle, HasThePeriodThatNoiseLeaves) {
  for (const double period : {1.37, 1.0, 0.7313}) {
    Rig rig;
    rig.period = period;
    rig.approach = 1.3;
    const auto mean = mean_cycle(record_of(rig));
    ASSERT_TRUE(mean);
    EXPECT_NEAR(mean->period(), period, 4e-6);
    // Means of six or less rows in each part.
    const double rows = period * rig.rows_per_second / 240;
    EXPECT_LT(mean->normal_scatter, 1.1 * rig.noise / std::sqrt(std::floor(rows)));
  }
}

TEST(MeanCycle, SaysHowCyclesScatter) {
  Rig rig;
  rig.noise = 1e-5;
  rig.amplitude_scatter = 0.03;
  rig.duration = 80;
  const auto mean = mean_cycle(record_of(rig));
  ASSERT_TRUE(mean);
  // Root mean square of a cosine of amplitude 0.5 * 0.03.
  EXPECT_NEAR(mean->tangential_scatter, 0.5 * 0.03 / std::sqrt(2), 0.003);
  EXPECT_LT(mean->normal_scatter, 1e-3);
}

TEST(MeanCycle, LeavesTheApproachOut) {
  Rig rig;
  rig.approach = 2;
  const auto mean = mean_cycle(record_of(rig));
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->period(), 1.37, 3e-4);
  EXPECT_GE(mean->n_cycles, 14U);
  EXPECT_GE(mean->n_before, 2000U);
  EXPECT_NEAR(amplitude_of(mean->cycle, mean->cycle.normal, 1), 0.2, 1e-3);
}

TEST(MeanCycle, OfAConstantDepthComesFromTheOtherSignal) {
  auto record = record_of({});
  std::mt19937 engine(5);
  std::normal_distribution<double> scatter(0, 1e-3);
  for (double& d : record.normal) d = 1 + scatter(engine);
  const auto mean = mean_cycle(record);
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->period(), 1.37 / 2, 1e-3);
}

TEST(MeanCycle, IsNoneOfWhatDoesNotRepeat) {
  Record record;
  for (int i = 0; i < 1000; ++i) {
    record.time.push_back(i);
    record.normal.push_back(1 + i / 1000.0);
    record.tangential.push_back(std::sqrt(i));
  }
  EXPECT_FALSE(mean_cycle(record));
  EXPECT_FALSE(mean_cycle({{0, 1, 2}, {1, 2, 1}, {0, 1, 0}}));
}

}  // namespace
}  // namespace fretval::mdr::mean_cycle_test
