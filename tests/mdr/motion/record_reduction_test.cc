#include "mdr/motion/record_reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace fretval::mdr::record_reduction_test {
namespace {

constexpr double two_pi = 6.283185307179586;

/// Three cycles of 1 + 0.2 cos and 0.5 cos 2, over 3 s.
Record cosines(std::size_t n, double noise) {
  std::mt19937 engine(7);
  std::normal_distribution<double> scatter(0, 1);
  Record record;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = 3 * static_cast<double>(i) / static_cast<double>(n - 1);
    record.time.push_back(t);
    record.normal.push_back(1 + 0.2 * std::cos(two_pi * t) + noise * scatter(engine));
    record.tangential.push_back(0.5 * std::cos(2 * two_pi * t) + noise * scatter(engine));
  }
  return record;
}

/// Largest distance from the cosines without noise.
double distance_from_cosines(const Record& record) {
  double largest = 0;
  std::size_t k = 0;
  for (int i = 0; i <= 3000; ++i) {
    const double t = 3 * i / 3000.0;
    while (k + 2 < record.time.size() && record.time[k + 1] < t) ++k;
    const double share = (t - record.time[k]) / (record.time[k + 1] - record.time[k]);
    const double normal = record.normal[k] + share * (record.normal[k + 1] - record.normal[k]),
                 tangential = record.tangential[k] + share * (record.tangential[k + 1] - record.tangential[k]);
    largest = std::max({largest, std::abs(normal - 1 - 0.2 * std::cos(two_pi * t)),
                        std::abs(tangential - 0.5 * std::cos(2 * two_pi * t))});
  }
  return largest;
}

TEST(RecordReduction, StaysWithinTheToleranceOfEveryRow) {
  const auto record = cosines(6001, 0);
  const auto few = reduced(record, 1e-3, 1e-3, 1000);
  EXPECT_LE(few.normal_error, 1e-3);
  EXPECT_LE(few.tangential_error, 1e-3);
  EXPECT_LE(distance_from_cosines(few.record), 1e-3 + 1e-6);
  // Chords of equal sagitta under 0.5 cos(2 t) alone are 300.
  EXPECT_LT(few.record.time.size(), 450U);
  const auto more = reduced(record, 1e-4, 1e-4, 1000);
  // Half the distance between rows for a quarter of the error, but halvings go by twos.
  const double growth = static_cast<double>(more.record.time.size()) / static_cast<double>(few.record.time.size());
  EXPECT_GT(growth, std::sqrt(10) / 2);
  EXPECT_LT(growth, 2 * std::sqrt(10));
}

TEST(RecordReduction, KeepsRowsWhereASignalTurns) {
  Record record;
  for (int i = 0; i <= 400; ++i) {
    record.time.push_back(i);
    record.normal.push_back(1);
    record.tangential.push_back(i < 101 ? i : i < 303 ? 202 - i : i - 404);
  }
  const auto [few, normal_error, tangential_error] = reduced(record, 1e-9, 1e-9, 100);
  EXPECT_EQ(few.time, (std::vector<double>{0, 101, 303, 400}));
  EXPECT_EQ(few.tangential, (std::vector<double>{0, 101, -101, -4}));
  EXPECT_EQ(normal_error, 0);
  EXPECT_LT(tangential_error, 1e-9);
}

TEST(RecordReduction, SeesThroughNoise) {
  const double noise = 0.01;
  const auto record = cosines(200'001, noise);
  EXPECT_NEAR(white_noise_of(record.normal), noise, 0.01 * noise);
  const auto few = reduced(record, 1e-5, 1e-5, 1000);
  EXPECT_LE(few.record.time.size(), 1000U);
  const double off = distance_from_cosines(few.record);
  EXPECT_LT(off, noise / 2);
  EXPECT_LE(off, std::max(few.normal_error, few.tangential_error));
}

TEST(RecordReduction, OfNoNoiseFindsNone) {
  EXPECT_LT(white_noise_of(cosines(6001, 0).normal), 1e-6);
  EXPECT_EQ(white_noise_of({1, 2}), 0);
}

TEST(RecordReduction, LeavesFewRowsWhateverTheTolerance) {
  EXPECT_LE(reduced(cosines(6001, 0), 1e-12, 1e-12, 200).record.time.size(), 200U);
}

TEST(RecordReduction, RefusesWhatIsNone) {
  EXPECT_THROW(reduced({{0}, {1}, {0}}, 1, 1, 10), std::invalid_argument);
  EXPECT_THROW(reduced(cosines(10, 0), 0, 1, 10), std::invalid_argument);
  EXPECT_THROW(reduced(cosines(10, 0), 1, 1, 3), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::record_reduction_test
