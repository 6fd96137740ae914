#include "comparison/verification/suite_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

TEST(SuiteJson, HasWhatIsThereAndNullForWhatIsNot) {
  auto run = mixed_run();
  run.rows.push_back(row_of(not_a_number, infinity, "broken"));
  run.rows[0].n_computations = 3;
  run.rows[1].n_computations = 4;
  const auto json = suite_json(run);
  EXPECT_EQ(json["suite"], "extremes");
  EXPECT_EQ(json["summary"]["pass"], false);
  EXPECT_EQ(json["summary"]["cases"], 5);
  EXPECT_EQ(json["summary"]["fail"], 2);
  EXPECT_EQ(json["summary"]["computations"], 7);
  EXPECT_EQ(json["quantities"][0]["above_bar"], 2);
  EXPECT_NEAR(json["quantities"][0]["error"]["median"].get<double>(), 1e-3, 1e-15);
  EXPECT_NEAR(json["quantities"][0]["error"]["high"].get<double>(), 3e-2, 1e-15);
  EXPECT_EQ(json["quantities"][0]["bar"]["high"], 2e-2);
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

TEST(SuiteJUnit, HasACaseARow) {
  const auto xml = suite_junit(mixed_run());
  expect_parts(xml, {"name=\"fretval check extremes\" tests=\"4\" failures=\"1\"", "name=\"family: good\"/>",
                     "name=\"family: wide (inconclusive)\"/>", "name=\"family: &lt;bad&gt;\"><failure"});
}

}  // namespace
}  // namespace fretval
