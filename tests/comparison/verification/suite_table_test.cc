#include "comparison/verification/suite_table.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(SuiteTable, HasALineARowAndAQuantity) {
  expect_parts(suite_table(mixed_run()),
               {"family\n  agrees       good    stick_radius_shakedown     0.600000   0.601000   1.0e-03  2.0e-03   "
                "1.0e-02   0.00\n",
                "inconclusive wide", "bar 2.0e-02, mostly rings, tolerance 1e-02\n", "FAIL         <bad>",
                "is above its bar 2.0e-03\n", "refused      refused -", "a b\n",
                "stick_radius_shakedown     1.0e-02      3         1      1         0   1.0e-03   3.0e-02",
                "memory: 200 MB\n", "draws: 30: too many\n",
                "FAIL: 4 cases: 1 agree, 1 refused as expected, 1 inconclusive, 1 FAIL; 2 of 3 errors are covered\n"});
  expect_parts(suite_table(run_of({row_of(1e-3, 2e-3)})), {"pass: 1 cases: 1 agree"});
}

TEST(SuiteTable, HasTheWorstOfManyRowsAlone) {
  std::vector<SuiteRow> rows(300, row_of(1e-3, 2e-3, "usual"));
  rows[200] = row_of(1.5e-3, 2e-3, "worst");
  const auto table = suite_table(run_of(rows));
  expect_parts(table, {"the worst of 300\n", "agrees       family: worst", "pass: 300 cases"});
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 1 + 1 + 10 + 1 + 1 + 1);
}

TEST(SuiteJUnit, HasACaseARowAndACheck) {
  const auto xml = suite_junit(mixed_run());
  expect_parts(xml, {"name=\"fretval check extremes\" tests=\"6\" failures=\"2\"", "name=\"family: good\"/>",
                     "name=\"family: wide (inconclusive)\"/>", "name=\"family: &lt;bad&gt;\"><failure",
                     "name=\"memory\"/>", "name=\"draws\"><failure message=\"too many\"/>"});
}

}  // namespace
}  // namespace fretval
