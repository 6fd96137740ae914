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

// Of six rows: two errors above their bars, three bars above the tolerance, one of them without bounds.
TEST(SuiteJson, CountsAndSpreadsOverAllRows) {
  const auto json = suite_json(run_of({row_of(1e-3, 2e-3), row_of(-4e-3, 2e-3), row_of(2e-3, infinity),
                                       row_of(4e-2, 3e-2), row_of(1e-2, 4e-2), row_of(1e-3, 8e-3)}));
  auto found = json["quantities"][0];
  const auto close = [&](const char* what, double median, double high) {
    EXPECT_NEAR(found[what]["median"], median, 1e-9 * median) << what;
    EXPECT_NEAR(found[what]["high"], high, 1e-9 * high) << what;
    found.erase(what);
  };
  close("error", 2e-3, 4e-2);
  close("bar", 8e-3, 4e-2);
  close("effectivity", 2, 8);
  EXPECT_EQ(found, nlohmann::ordered_json::parse(R"({"quantity": "stick_radius_shakedown", "tolerance": 0.01,
    "errors": 6, "above_bar": 2, "wide": 3})"));
  auto summary = json["summary"];
  EXPECT_EQ(summary["errors"], 6);
  EXPECT_EQ(summary["above_bar"], 2);
  EXPECT_EQ(summary["agree"], 2);
  EXPECT_EQ(summary["inconclusive"], 1);
  EXPECT_EQ(summary["fail"], 3) << "no bar at all proves nothing";
}

TEST(SuiteJUnit, HasACaseARow) {
  const auto xml = suite_junit(mixed_run());
  expect_parts(xml, {"name=\"fretval check extremes\" tests=\"4\" failures=\"1\"", "name=\"family: good\"/>",
                     "name=\"family: wide (inconclusive)\"/>", "name=\"family: &lt;bad&gt;\"><failure"});
}

}  // namespace
}  // namespace fretval
