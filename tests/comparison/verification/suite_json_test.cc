#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "comparison/verification/suite.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/suite_rows.h"

namespace fretval::suite_json_test {
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

// Of 20 errors 18 are no larger than 1.8e-3.
TEST(SuiteJson, HasWhatNineTenthsAreBelow) {
  std::vector<SuiteRow> rows;
  for (int k = 1; k <= 20; ++k) rows.push_back(row_of(1e-4 * k, 5e-3));
  const auto high = suite_json(run_of(rows))["quantities"][0]["error"]["high"].get<double>();
  EXPECT_GE(high, 1.8e-3 * (1 - 1e-9));
  EXPECT_LT(high, 1.95e-3);
}

TEST(SuiteJson, AddsUpTheErrorsOfAllQuantities) {
  auto both = row_of(1e-3, 2e-3);
  both.compared[Quantity::normal_force_max] = {1, 1.5, 1e-3, 1e-4, "rings"};
  const auto summary = suite_json(run_of({row_of(1e-3, 2e-3), both, row_of(3e-3, 2e-3)}))["summary"];
  EXPECT_EQ(summary["errors"], 4);
  EXPECT_EQ(summary["above_bar"], 2);
}

TEST(SuiteJUnit, HasACaseARow) {
  const auto xml = suite_junit(mixed_run());
  expect_parts(xml, {"name=\"fretval check extremes\" tests=\"4\" failures=\"1\"", "name=\"family: good\"/>",
                     "name=\"family: wide (inconclusive)\"/>", "name=\"family: &lt;bad&gt;\"><failure"});
}

TEST(QuantitySummary, IsByQuantityAndTolerance) {
  auto other = row_of(1e-3, 2e-3);
  other.compared[Quantity::normal_force_max] = {1, 1, 1e-3, 1e-4, "rings"};
  other.compared[Quantity::stick_radius_shakedown].tolerance = 1e-4;
  const auto all = quantity_summaries({row_of(1e-3, 2e-3), row_of(-4e-3, 2e-3), row_of(2e-3, infinity),
                                       row_of(not_a_number, 3e-2), row_of(0, 2e-3), other});
  ASSERT_EQ(all.size(), 3U);
  const auto& force = all.at({Quantity::normal_force_max, 1e-3});
  EXPECT_EQ(force.errors, std::vector<double>{0});
  EXPECT_TRUE(force.effectivities.empty()) << "of an error that is zero";
  EXPECT_EQ(all.at({Quantity::stick_radius_shakedown, 1e-4}).n_wide, 1U);
  const auto& usual = all.at({Quantity::stick_radius_shakedown, 1e-2});
  EXPECT_EQ(usual.n, 5U);
  EXPECT_EQ(usual.n_above, 2U);
  EXPECT_EQ(usual.n_wide, 2U);
  EXPECT_EQ(usual.errors.size(), 4U);
  EXPECT_EQ(usual.bars, (std::vector<double>{2e-3, 2e-3, 2e-3}));
  ASSERT_EQ(usual.effectivities.size(), 2U);
  EXPECT_NEAR(usual.effectivities[0], 2, 1e-12);
  EXPECT_NEAR(usual.effectivities[1], 0.5, 1e-12);
}

TEST(ShownRows, AreAllOfASmallSuite) {
  const std::vector<SuiteRow> rows{row_of(1e-3, 2e-3), row_of(3e-2, 2e-3)};
  ASSERT_EQ(shown_rows(rows).size(), 2U);
  EXPECT_EQ(shown_rows(rows)[0], &rows[0]);
}

TEST(ShownRows, AreTheWorstOfALargeOne) {
  std::vector<SuiteRow> rows(300, row_of(1e-3, 2e-3));
  rows[250] = row_of(1.9e-3, 2e-3);
  EXPECT_EQ(shown_rows(rows).size(), 10U);
  EXPECT_EQ(shown_rows(rows)[0], &rows[250]);
  for (std::size_t k = 100; k < 120; ++k) rows[k] = row_of(3e-3, 2e-3);
  rows[299].failure = "singular";
  ASSERT_EQ(shown_rows(rows).size(), 21U) << "every one that fails";
  EXPECT_EQ(shown_rows(rows).back(), &rows[299]);
}

TEST(WorstQuantity, IsTheClosestToItsBar) {
  EXPECT_EQ(worst_of(SuiteRow{}), nullptr);
  auto row = row_of(1e-3, 2e-3);
  row.compared[Quantity::contact_radius_max] = {1, 1.003, 1e-3, 4e-3, "rings"};
  EXPECT_EQ(worst_of(row)->first, Quantity::contact_radius_max);
  row.compared[Quantity::stick_radius_first_slip] = {0.5, not_a_number, 1e-2, 1e-3, "rings"};
  EXPECT_EQ(worst_of(row)->first, Quantity::stick_radius_first_slip);
}

TEST(Remark, SaysWhyARowFailsIsRefusedOrIsInconclusive) {
  EXPECT_EQ(remark_of(row_of(1e-3, 2e-3)), "");
  EXPECT_EQ(remark_of(refused_row("a", "a b")), "a b");
  EXPECT_EQ(remark_of(refused_row("", "a b")), "refused: a b");
  EXPECT_EQ(remark_of(row_of(1e-3, 2e-2)), "stick radius, shakedown: bar 2.0e-02, mostly rings, tolerance 1e-02");
}

}  // namespace
}  // namespace fretval::suite_json_test
