#include "comparison/verification/suite_table.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/verification/suite_json.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

SuiteRun mixed() {
  auto run = run_of(
      {row_of(1e-3, 2e-3, "good"), row_of(1e-3, 2e-2, "wide"), row_of(3e-2, 2e-3, "<bad>"), refused_row("a", "a b")});
  run.checks = {{"memory", "200 MB", ""}, {"draws", "30", "too many"}};
  return run;
}

TEST(SuiteTable, HasALineARowAndAQuantity) {
  expect_parts(suite_table(mixed()),
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
  const auto xml = suite_junit(mixed());
  expect_parts(xml, {"name=\"fretval check extremes\" tests=\"6\" failures=\"2\"", "name=\"family: good\"/>",
                     "name=\"family: wide (inconclusive)\"/>", "name=\"family: &lt;bad&gt;\"><failure",
                     "name=\"memory\"/>", "name=\"draws\"><failure message=\"too many\"/>"});
}

TEST(SuiteJson, HasWhatIsThereAndNullForWhatIsNot) {
  auto run = mixed();
  run.rows.push_back(row_of(not_a_number, infinity, "broken"));
  run.rows[0].n_computations = 3;
  run.rows[1].n_computations = 4;
  const auto json = suite_json(run);
  EXPECT_EQ(json["suite"], "extremes");
  EXPECT_EQ(json["summary"]["pass"], false);
  EXPECT_EQ(json["summary"]["cases"], 5);
  EXPECT_EQ(json["summary"]["fail"], 2);
  EXPECT_EQ(json["summary"]["computations"], 7);
  EXPECT_EQ(json["checks"][1]["failure"], "too many");
  EXPECT_TRUE(json["checks"][0]["failure"].is_null());
  EXPECT_EQ(json["quantities"][0]["above_bar"], 2);
  const auto& good = json["rows"][0];
  EXPECT_EQ(good["verdict"], "agrees");
  EXPECT_EQ(good["worst"], "stick_radius_shakedown");
  EXPECT_NEAR(good["quantities"]["stick_radius_shakedown"]["error"].get<double>(), 1e-3, 1e-15);
  EXPECT_EQ(good["case_file"], "text of good");
  EXPECT_TRUE(good["remark"].is_null());
  EXPECT_EQ(json["rows"][3]["refusal"], "a b");
  EXPECT_TRUE(json["rows"][3]["worst"].is_null());
  EXPECT_TRUE(json["rows"][4]["quantities"]["stick_radius_shakedown"]["bar"].is_null());
  EXPECT_TRUE(json["rows"][4]["quantities"]["stick_radius_shakedown"]["fe"].is_null());
}

}  // namespace
}  // namespace fretval
