#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "comparison/data/path_table.h"
#include "tests/comparison/expect_parts.h"

namespace fretval::record_test {
namespace {

constexpr double two_pi = 6.283185307179586;

/// d = 100 um + 10 um cos, u_x = 5 um cos, at 1 Hz, with a standard deviation of noise.
Case::Path record(double duration, int rows_per_second, double noise, bool repeats, double approach = 0) {
  std::mt19937 engine(11);
  std::normal_distribution<double> scatter(0, 1);
  Case::Path path{{{}, {}, {}, repeats}, "rig.csv"};
  const int n = static_cast<int>((duration + approach) * rows_per_second);
  for (int i = 0; i <= n; ++i) {
    const double t = static_cast<double>(i) / rows_per_second - approach;
    const double d = t < 0 ? 110e-6 + 150e-6 * t / approach : 100e-6 + 10e-6 * std::cos(two_pi * t);
    path.time.push_back(t + approach);
    path.normal.push_back(d + noise * scatter(engine));
    path.tangential.push_back((t < 0 ? 5e-6 : 5e-6 * std::cos(two_pi * t)) + noise * scatter(engine));
  }
  return path;
}

double half_range(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return (*most - *least) / 2;
}

TEST(Record, OfFewRowsIsTheFile) {
  std::vector<std::string> notes;
  const auto path = path_of_record(record(1, 100, 0, true), {}, notes);
  EXPECT_EQ(path.time.size(), 101U);
  EXPECT_FALSE(path.reduction);
  EXPECT_TRUE(notes.empty());
}

TEST(Record, OfManyRowsIsReducedWithinAToleranceOfItsOwn) {
  std::vector<std::string> notes;
  PathTolerance tolerance;
  tolerance.relative = 1e-3 / 8;
  const auto path = path_of_record(record(1, 100'000, 0, false), tolerance, notes);
  ASSERT_TRUE(path.reduction);
  EXPECT_LT(path.time.size(), 300U);
  EXPECT_LE(path.reduction->normal_error, 110e-6 * 1e-3 / 8);
  EXPECT_LE(path.reduction->tangential_error, 5e-6 * 1e-3 / 8);
  EXPECT_NEAR(half_range(path.tangential), 5e-6, 1e-15);  // where it turns is kept
  expect_parts(notes.at(0), {"rig.csv", "of 100001 rows describe the record within"});
}

TEST(Record, TakesAGivenTolerance) {
  std::vector<std::string> notes;
  PathTolerance tolerance;
  tolerance.is_given = true;
  tolerance.length = 1e-6;
  const auto path = path_of_record(record(1, 1000, 0, true), tolerance, notes);
  EXPECT_LT(path.time.size(), 12U);
  EXPECT_LE(path.reduction->normal_error, 1e-6);
  EXPECT_EQ(path.normal.front(), path.normal.back());
}

TEST(Record, ThatRepeatsIsFoldedToItsMeanCycle) {
  std::vector<std::string> notes;
  const double noise = 0.05e-6;
  const auto path = path_of_record(record(20.37, 1000, noise, true), {}, notes);
  ASSERT_TRUE(path.reduction);
  EXPECT_EQ(path.reduction->n_cycles, 20U);
  EXPECT_NEAR(path.duration(), 1, 2e-4);
  EXPECT_EQ(path.normal.front(), path.normal.back());
  EXPECT_NEAR(half_range(path.normal), 10e-6, 2 * noise / std::sqrt(20));
  // Means of four rows in each part of a cycle scatter by half of the noise.
  EXPECT_NEAR(path.reduction->normal_scatter, noise / 2, 0.1 * noise);
  expect_parts(notes.at(0), {"folded to the mean of 20 cycles"});
}

TEST(Record, BeginsWithTheContact) {
  std::vector<std::string> notes;
  const auto path = path_of_record(record(1, 500, 0, false, 2), {}, notes);
  ASSERT_TRUE(path.reduction);
  // d = 0 after 2 s (1 - 110/150).
  EXPECT_NEAR(path.time.front(), 2 * (1 - 110.0 / 150), 1e-12);
  EXPECT_EQ(path.normal.front(), 0);
  EXPECT_TRUE(path.from_touch);
  EXPECT_EQ(path.reduction->n_cut + path.time.size(), 1502U) << "the touch lies between two rows";
  expect_parts(notes.at(0), {"rows before the contact", "cut off"});
}

// In contact by less than four standard deviations of the noise, or by more.
TEST(Record, IsInContactAtRestByMoreThanNoise) {
  for (const double rest : {2e-7, 6e-7}) {
    std::mt19937 engine(5);
    std::normal_distribution<double> noise(0, 1e-7);
    Case::Path press{{{}, {}, {}, false}, "press.csv"};
    for (int i = 0; i <= 200; ++i) {
      press.time.push_back(0.01 * i);
      press.normal.push_back(rest + 1e-5 * press.time.back() + (i == 0 ? 0 : noise(engine)));
      press.tangential.push_back(0);
    }
    std::vector<std::string> notes;
    EXPECT_EQ(path_of_record(press, {}, notes).from_touch, rest < 4e-7) << rest;
  }
}

// Without noise a row at d = 0 is the touch itself, and is no row before the contact.
TEST(Record, KeepsARowAtTheTouch) {
  std::vector<std::string> notes;
  const auto path =
      path_of_record({{{0, 1, 2, 3}, {0, 1e-5, 2e-5, 1e-5}, {0, 0, 1e-6, 0}, false}, "press.csv"}, {}, notes);
  EXPECT_TRUE(path.from_touch);
  EXPECT_EQ(path.time.size(), 4U);
  EXPECT_TRUE(notes.empty());
}

TEST(Record, BeginsWhereMeansOfNoisyRowsTouchTheSurface) {
  PathTolerance tolerance;
  tolerance.length = 2e-7;
  tolerance.is_given = true;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> noise(0, 1e-7);
    Case::Path ramp{{{}, {}, {}, false}, "ramp.csv"};
    for (int i = 0; i <= 5000; ++i) {
      const double t = 1e-3 * i;
      ramp.time.push_back(t);
      ramp.normal.push_back(4e-6 * t + noise(engine));
      ramp.tangential.push_back(1e-6 * t + noise(engine));
    }
    std::vector<std::string> notes;
    const auto path = path_of_record(std::move(ramp), tolerance, notes);
    EXPECT_TRUE(path.from_touch) << seed;
    EXPECT_EQ(path.normal[0], 0) << seed;
    EXPECT_GT(path.normal[1], 0) << seed;
    // On the ramp within the errors that are told of its rows.
    EXPECT_NEAR(path.normal[0], 4e-6 * path.time[0], path.reduction->normal_error) << seed;
    EXPECT_NEAR(path.tangential[0], 1e-6 * path.time[0], path.reduction->tangential_error) << seed;
  }
}

TEST(Record, ThatNeitherClosesNorRepeatsIsRefused) {
  std::vector<std::string> notes;
  Case::Path path{{{0, 1, 2, 3}, {1e-4, 1.1e-4, 1.2e-4, 1.3e-4}, {0, 0, 0, 0}, true}, "rig.csv"};
  expect_parts(refusal([&] { path_of_record(path, {}, notes); }), {"rig.csv: d jumps by -3e-05 m", "shows no period"});
}

TEST(Record, ThatHardlyJumpsIsClosedByARamp) {
  std::vector<std::string> notes;
  Case::Path path{{{0, 1, 2, 3}, {1e-4, 1.2e-4, 0.9e-4, 1.001e-4}, {0, 1e-6, -1e-6, 2e-9}, true}, "rig.csv"};
  const auto closed = path_of_record(path, {}, notes);
  EXPECT_EQ(closed.normal.front(), closed.normal.back());
  EXPECT_NEAR(closed.reduction->normal_error, 1e-7, 1e-18);
  expect_parts(notes.at(0), {"rig.csv: closed by a ramp over the jumps of -1e-07 m and -2e-09 m from its end"});
}

// Between rows of -5 and 15 um it touches after a quarter of the way, in u_x as in t.
TEST(Record, BeginsWhereTheIndenterIsAsItTouches) {
  std::vector<std::string> notes;
  const auto path = path_of_record(
      {{{0, 1, 2, 3, 4}, {-1e-5, -5e-6, 1.5e-5, 2e-5, 2e-5}, {0, 1e-6, 5e-6, 6e-6, 6e-6}, false}, "press.csv"}, {},
      notes);
  ASSERT_EQ(path.time.size(), 4U);
  EXPECT_NEAR(path.time.front(), 1.25, 1e-12);
  EXPECT_NEAR(path.tangential.front(), 2e-6, 1e-18);
}

// The ramp begins with the record, whenever that is: after a third of the time a third of the jump is taken off.
TEST(Record, IsClosedByARampOverItsOwnTime) {
  std::vector<std::string> notes;
  const auto closed = path_of_record(
      {{{10, 11, 12, 13}, {1e-4, 1.2e-4, 0.9e-4, 1.003e-4}, {0, 1e-6, -1e-6, 0}, true}, "rig.csv"}, {}, notes);
  EXPECT_NEAR(closed.normal[0], 1e-4, 1e-16);
  EXPECT_NEAR(closed.normal[1], 1.2e-4 - 1e-7, 1e-16);
  EXPECT_NEAR(closed.normal[2], 0.9e-4 - 2e-7, 1e-16);
}

// A jump of 0.1 um, and rows left out within 1 nm.
TEST(Record, ThatIsClosedAndReducedIsOffByBoth) {
  auto rig = record(1, 1000, 0, true);
  rig.normal.back() += 1e-7;
  PathTolerance tolerance;
  tolerance.is_given = true;
  tolerance.length = 1e-9;
  std::vector<std::string> notes;
  const auto path = path_of_record(rig, tolerance, notes);
  ASSERT_TRUE(path.reduction);
  EXPECT_GE(path.reduction->normal_error, 1e-7 * (1 - 1e-9));
  EXPECT_LE(path.reduction->normal_error, 1e-7 + 1e-9);
}

}  // namespace
}  // namespace fretval::record_test
