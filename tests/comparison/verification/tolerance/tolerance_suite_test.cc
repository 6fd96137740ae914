#include "comparison/verification/tolerance/tolerance_suite.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "comparison/report/tolerance_section.h"
#include "comparison/verification/tolerance/tolerance_cases.h"
#include "comparison/verification/tolerance/tolerance_grid.h"
#include "comparison/verification/tolerance/tolerance_json.h"
#include "comparison/verification/tolerance/tolerance_table.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {
namespace {

std::vector<PreparedCase> some_cases(double tolerance) {
  auto cases = tolerance_cases(tolerance);
  cases.erase(std::remove_if(cases.begin(), cases.end(),
                             [](const Case& scene) {
                               return scene.name != "parabola-elastic-90" && scene.name != "cone-solid-45";
                             }),
              cases.end());
  return prepare(cases);
}

ToleranceRecord record(const std::string& name, double error, double bar) {
  ToleranceRecord r{};
  r.name = name;
  r.tolerance = 1e-3;
  r.resolution = resolution_for(1e-3);
  r.errors["stick_radius_shakedown"] = {error, 1e-3, bar};
  r.economised.seconds = 0.3;
  return r;
}

TEST(ToleranceCases, AreFiftyAndCoverWhatTheyShould) {
  const auto cases = tolerance_cases(1e-3);
  EXPECT_EQ(cases.size(), 50U);
  std::set<std::string> rheologies, names;
  std::set<Case::Shape> shapes;
  int n_unlocked = 0, n_at_rest = 0, n_without_first_slip = 0, n_small = 0, n_narrow = 0;
  for (const auto& prepared : prepare(cases)) {
    const auto& scene = prepared.scene;
    names.insert(scene.name);
    rheologies.insert(scene.elastomer.rheology);
    shapes.insert(scene.indenter.shape);
    n_unlocked += !scene.motion.phase;
    n_at_rest += scene.motion.tangential_amplitude == 0;
    const auto& mdr = prepared.mdr;
    const auto radii = mdr::stick_radii(mdr.profile, mdr.body, mdr.friction_coefficient, mdr.motion);
    n_without_first_slip += !radii.first_slip;
    const double c = radii.shakedown.value_or(0) / prepared.fem.units.length;
    n_small += c > 0 && c < 0.11;
    n_narrow += c > 0.98 && c < 1;
  }
  EXPECT_EQ(names.size(), 50U);
  EXPECT_EQ(rheologies.size(), 4U);
  EXPECT_EQ(shapes.size(), 5U);
  EXPECT_GE(n_unlocked, 3);
  EXPECT_EQ(n_at_rest, 2);
  EXPECT_GE(n_without_first_slip, 2);
  EXPECT_GE(n_small, 5);
  EXPECT_GE(n_narrow, 4);
}

TEST(ToleranceSuite, MeetsATolerance) {
  const auto cases = some_cases(1e-2);
  const auto records = tolerance_records(cases, exact_answers(cases));
  ASSERT_EQ(records.size(), 2U);
  for (const auto& r : records) EXPECT_TRUE(r.passes()) << tolerance_table({r});
}

TEST(ToleranceSuiteGuard, ReportsAMissForAnotherScene) {
  auto cases = some_cases(1e-2);
  const auto exact = exact_answers(cases);
  for (auto& prepared : cases) prepared.fem.friction_coefficient *= 1.4;
  for (const auto& r : tolerance_records(cases, exact)) {
    EXPECT_FALSE(r.passes());
    EXPECT_FALSE(r.meets()) << tolerance_table({r});
  }
}

TEST(ToleranceGrid, FindsTheCheapestSettingThatMeetsATolerance) {
  auto cases = some_cases(1e-2);
  cases.resize(1);
  const auto exact = exact_answers(cases);
  auto hopeless = record(cases.front().scene.name, 0, 1e-3), easy = hopeless;
  hopeless.tolerance = 1e-15;
  easy.tolerance = 1e-1;
  std::vector<ToleranceRecord> records{easy, hopeless};
  search_grid(cases, exact, records);
  ASSERT_TRUE(records[0].cheapest);
  EXPECT_LE(records[0].cheapest->resolution.elements_per_radius, 32U);
  EXPECT_TRUE(records[1].in_grid);
  EXPECT_FALSE(records[1].cheapest);
}

TEST(ToleranceGrid, IsOfModerateSize) {
  EXPECT_LE(grid_of_settings().size(), 60U);
}

TEST(ToleranceTable, TellsMissesFromUncoveredAndInconclusive) {
  const auto good = record("good", 1e-4, 5e-4), miss = record("miss", 2e-3, 9e-4), wide = record("wide", 1e-4, 2e-3);
  const auto uncovered = record("uncovered", 4e-4, 3e-4);
  EXPECT_TRUE(good.passes());
  EXPECT_FALSE(miss.passes());
  EXPECT_FALSE(uncovered.passes());
  EXPECT_TRUE(wide.inconclusive());
  const auto table = tolerance_table({good, miss, wide, uncovered});
  EXPECT_NE(table.find("3/4"), std::string::npos) << table;
  EXPECT_NE(table.find("miss at 1e-03: MISSES, NOT COVERED"), std::string::npos) << table;
  EXPECT_NE(table.find("wide at 1e-03: inconclusive"), std::string::npos) << table;
  EXPECT_EQ(table.find("good at"), std::string::npos) << table;
  EXPECT_NE(tolerance_junit({good, miss, uncovered}).find("tests=\"3\" failures=\"2\""), std::string::npos);
}

TEST(ToleranceTable, ComparesCosts) {
  auto searched = record("searched", 1e-4, 5e-4);
  searched.in_grid = true;
  searched.cheapest = Cheapest{resolution_for(1e-2), 0.1};
  auto unmet = record("unmet", 1e-4, 5e-4);
  unmet.in_grid = true;
  const auto all = summaries({searched, unmet});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_NEAR(all.front().largest_cost_ratio.value(), 3, 1e-12);
  EXPECT_EQ(all.front().n_not_in_grid, 1U);
  EXPECT_NEAR(all.front().median_effectivity.value(), 5, 1e-12);
}

TEST(ToleranceJson, HasWhatTheReportShows) {
  auto searched = record("<searched>", 1e-4, std::numeric_limits<double>::infinity());
  searched.in_grid = true;
  searched.cheapest = Cheapest{resolution_for(1e-2), 0.1};
  const auto json = tolerance_json({searched, record("other", 2e-3, 3e-3)});
  EXPECT_EQ(json["records"].size(), 2U);
  EXPECT_TRUE(json["records"][0]["errors"]["stick_radius_shakedown"]["bar"].is_null());
  EXPECT_FALSE(json["records"][1]["pass"]);
  const auto html = tolerance_section(json);
  EXPECT_NE(html.find("<svg"), std::string::npos);
  EXPECT_NE(html.find("&lt;searched&gt;"), std::string::npos) << html;
  EXPECT_EQ(tolerance_section(nlohmann::ordered_json::object()), "");
}

}  // namespace
}  // namespace fretval
