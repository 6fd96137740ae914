#include "fem/history/drive_to_period.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace fretval::fem::drive_to_period_test {
namespace {

/// A response whose changes fall by a ratio in each period, with a log of what is done to it: a period, a search.
struct FallingWay : PlainWay {
  double falls_by = 0.5, enough = 1e-3, found = 0, now = 1, last_change = 1;
  int n_periods = 0, n_start = 0, most = 100;
  bool passes = false;
  std::string log;

  bool is_at_end(double /*periodicity*/) const { return n_periods == most; }
  void step_through_period() {
    last_change = now;
    now *= falls_by;
    ++n_periods;
    log += 'p';
  }
  bool is_single_pass() const { return passes; }
  bool is_in_start() const { return n_periods < n_start; }
  double change() const { return last_change; }
  bool goes_on(double periodicity, double /*change*/) const { return periodicity > enough; }
  double search() {
    log += 's';
    now = found;
    return found;
  }
};

TEST(DriveToPeriod, EndsWithThePeriodThatRepeats) {
  FallingWay way;
  const auto drive = drive_to_period(way, {});
  EXPECT_EQ(way.n_periods, 11);  // 2^-10 < 1e-3
  EXPECT_DOUBLE_EQ(drive.periodicity, std::pow(0.5, 10));
  EXPECT_FALSE(drive.moved);
}

TEST(DriveToPeriod, DoesNotJudgeItsStart) {
  FallingWay way;
  way.n_start = 20;
  drive_to_period(way, {});
  EXPECT_EQ(way.n_periods, 20);
}

TEST(DriveToPeriod, EndsWhereTheWayDoes) {
  FallingWay way;
  way.most = 3;
  EXPECT_DOUBLE_EQ(drive_to_period(way, {}).periodicity, 0.25);
  EXPECT_EQ(way.n_periods, 3);
}

TEST(DriveToPeriod, HasOnePeriodOfASinglePass) {
  FallingWay way;
  way.passes = true;
  EXPECT_EQ(drive_to_period(way, {10, 4}).periodicity, 0);
  EXPECT_EQ(way.log, "p");
}

// The period after a search is not compared with the one before it; two plain ones are what shows that a state repeats.
TEST(DriveToPeriod, ComparesPlainPeriodsAlone) {
  FallingWay way;
  way.falls_by = 1 - 1e-3;
  const auto drive = drive_to_period(way, {1000, 1});
  EXPECT_EQ(way.log, "pspp");
  EXPECT_TRUE(drive.moved);
  EXPECT_LT(drive.periodicity, 1e-3);
  FallingWay at_once;
  at_once.falls_by = 1 - 1e-3;
  drive_to_period(at_once, {1000, 4, true});
  EXPECT_EQ(at_once.log, "spp");
}

// A body that creeps for n periods goes on changing for as long: what is to come counts, not what a period shows.
TEST(DriveToPeriod, WaitsForWhatIsToCome) {
  FallingWay slow;
  slow.falls_by = std::exp(-1 / 50.);
  slow.most = 10000;
  drive_to_period(slow, {50});
  EXPECT_LT(50 * slow.now, 1e-3);
}

// What a search has found bounds what is to come, also of a body that creeps for long.
TEST(DriveToPeriod, BelievesASearch) {
  FallingWay way;
  way.found = 1e-4;
  way.falls_by = 1;
  EXPECT_DOUBLE_EQ(drive_to_period(way, {1000, 4}).periodicity, 1e-4);
  EXPECT_EQ(way.log, "pspp");
}

}  // namespace
}  // namespace fretval::fem::drive_to_period_test
