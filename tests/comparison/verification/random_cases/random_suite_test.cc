#include "comparison/verification/random_cases/random_suite.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/verification/suite_json.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

SuiteRun only(std::size_t number) {
  return run_random_suite({1, 1, number});
}

TEST(RandomSuiteSlow, RunsEveryCaseWithinItsBars) {
  const auto run = run_random_suite({1, 40});
  EXPECT_TRUE(run.passes()) << remarks_of(run);
  ASSERT_EQ(run.rows.size(), 40U);
  EXPECT_GT(suite_json(run)["summary"]["errors"].get<int>(), 150);
  long n_computations = 0;
  for (const auto& row : run.rows) {
    EXPECT_EQ(row.n_refinements, 0);
    n_computations += row.n_computations;
  }
  EXPECT_GT(n_computations, 300);
}

// Cases of which an error was above its bar, by what their bars missed: a flat face that sticks as a whole by a depth
// that is smaller than its error; a phase that drifts faster than the body relaxes, unworn and worn; the edge of a
// contact that travels by half a ring.
TEST(RandomSuiteSlow, KeepsWhatItFoundWithinTheBars) {
  for (const std::size_t number : {3484U, 9942U, 1824U, 8680U})
    EXPECT_EQ(failure_of(only(number).rows.front()), "") << number;
}

TEST(RandomSuite, RepeatsASingleCase) {
  const auto all = run_random_suite({1, 3});
  const auto one = only(2);
  ASSERT_EQ(one.rows.size(), 1U);
  EXPECT_EQ(one.rows[0].asked.name, "random-1-2");
  EXPECT_EQ(one.rows[0].asked.text, all.rows[2].asked.text);
  const auto &mine = one.rows[0].compared.at(Quantity::stick_radius_shakedown),
             &other = all.rows[2].compared.at(Quantity::stick_radius_shakedown);
  EXPECT_EQ(mine.fe, other.fe);
  EXPECT_EQ(mine.bar, other.bar);
}

}  // namespace
}  // namespace fretval
