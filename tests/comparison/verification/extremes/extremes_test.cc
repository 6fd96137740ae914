#include "comparison/verification/extremes/extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "comparison/report/extremes_section.h"
#include "comparison/simulation/body.h"
#include "comparison/simulation/fem_case.h"
#include "comparison/verification/extremes/extremes_json.h"
#include "comparison/verification/extremes/extremes_table.h"
#include "comparison/verification/extremes/flat_mesh.h"
#include "meshes/audit.h"

namespace fretval {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

ExtremeRecord record(double error, double bar) {
  ExtremeRecord r;
  r.row.family = "family";
  r.row.value = "value";
  r.errors["stick_radius_shakedown"] = {0.6, 0.6 + error, error, 1e-2, bar, "rings"};
  return r;
}

ExtremeRecord refused(const std::string& expected, const std::string& message) {
  ExtremeRecord r;
  r.row.refusal = expected;
  r.refusal = message;
  return r;
}

TEST(ExtremeVerdict, AgreesWithinToleranceAndBar) {
  EXPECT_EQ(verdict_of(record(1e-3, 2e-3)), ExtremeVerdict::agrees);
  EXPECT_EQ(verdict_of(record(-1e-3, 2e-3)), ExtremeVerdict::agrees);
}

TEST(ExtremeVerdict, IsInconclusiveWithAWideBarThatCovers) {
  EXPECT_EQ(verdict_of(record(1e-3, 2e-2)), ExtremeVerdict::inconclusive);
  EXPECT_EQ(verdict_of(record(1.5e-2, 2e-2)), ExtremeVerdict::inconclusive);
}

TEST(ExtremeVerdict, FailsWithAnErrorAboveItsBar) {
  EXPECT_EQ(verdict_of(record(1e-3, 5e-4)), ExtremeVerdict::fails);
  EXPECT_EQ(verdict_of(record(3e-2, 2e-2)), ExtremeVerdict::fails);
  EXPECT_NE(failure_of(record(3e-2, 2e-2)).find("above its bar"), std::string::npos);
}

TEST(ExtremeVerdict, FailsWithoutFiniteNumbers) {
  EXPECT_EQ(verdict_of(record(not_a_number, 1e-3)), ExtremeVerdict::fails);
  EXPECT_EQ(verdict_of(record(1e-3, not_a_number)), ExtremeVerdict::fails);
  EXPECT_EQ(verdict_of(record(1e-3, infinity)), ExtremeVerdict::fails);
}

TEST(ExtremeVerdict, OneQuantityIsEnoughToFail) {
  auto r = record(1e-3, 2e-3);
  r.errors["normal_force_max"] = {1, 1.1, 0.1, 1e-3, 1e-4, "rings"};
  EXPECT_EQ(verdict_of(r), ExtremeVerdict::fails);
}

TEST(ExtremeVerdict, AcceptsARefusalOnlyWhereItIsExpected) {
  EXPECT_EQ(verdict_of(refused("Motion / Phase", "case.prm: Motion / Phase = x: ...")), ExtremeVerdict::refused);
  EXPECT_EQ(verdict_of(refused("", "case.prm: Motion / Phase = x: ...")), ExtremeVerdict::fails);
  EXPECT_EQ(verdict_of(refused("Motion / Phase", "out of memory")), ExtremeVerdict::fails);
  EXPECT_EQ(verdict_of(refused("Motion / Phase", "")), ExtremeVerdict::fails);
  auto answered = record(1e-3, 2e-3);
  answered.row.refusal = "Motion / Phase";
  EXPECT_EQ(verdict_of(answered), ExtremeVerdict::fails);
}

TEST(ExtremeVerdict, FailsWithoutAnyNumberOrWithAnotherException) {
  EXPECT_EQ(verdict_of({}), ExtremeVerdict::fails);
  auto r = record(1e-3, 2e-3);
  r.malfunction = "std::bad_alloc";
  EXPECT_EQ(verdict_of(r), ExtremeVerdict::fails);
  EXPECT_EQ(failure_of(r), "std::bad_alloc");
}

TEST(ExtremeVerdict, OfARefusedMotionNeedsTheSpringsToAgree) {
  auto r = record(1e-3, 2e-3);
  r.row.springs = true;
  r.row.refusal = r.refusal = "Motion / Tangential frequency";
  EXPECT_EQ(verdict_of(r), ExtremeVerdict::refused);
  r.errors["stick_radius_shakedown"].error = 3e-2;
  EXPECT_EQ(verdict_of(r), ExtremeVerdict::fails);
  r.errors.clear();
  EXPECT_EQ(verdict_of(r), ExtremeVerdict::fails);
}

TEST(ExtremeRows, CoverWhatTheyShould) {
  const auto rows = extreme_rows();
  std::set<std::string> names, families;
  for (const auto& row : rows) {
    EXPECT_TRUE(names.insert(row.family + ": " + row.value).second) << row.family << ": " << row.value;
    families.insert(row.family);
  }
  EXPECT_GE(rows.size(), 100U);
  EXPECT_GE(families.size(), 20U);
  EXPECT_TRUE(only_family(rows, "no such family").empty());
  EXPECT_EQ(only_family(rows, "power law").size(), 10U);
}

TEST(ExtremeRows, TheShortFormHasEveryKindOfRow) {
  const auto rows = short_extreme_rows();
  const auto has = [&](auto property) { return std::any_of(rows.begin(), rows.end(), property); };
  EXPECT_TRUE(has([](const ExtremeRow& r) { return r.refusal.empty(); }));
  EXPECT_TRUE(has([](const ExtremeRow& r) { return !r.refusal.empty() && !r.springs; }));
  EXPECT_TRUE(has([](const ExtremeRow& r) { return r.springs; }));
  EXPECT_EQ(rows.size(), 23U);
}

TEST(Extremes, OfTheShortFormEndInAnAnswerOrANamedRefusal) {
  const auto rows = short_extreme_rows();
  const auto records = run_extremes(rows);
  EXPECT_EQ(records.size(), rows.size());
  EXPECT_EQ(count(records, ExtremeVerdict::fails), 0U) << extremes_table(records);
  EXPECT_EQ(count(records, ExtremeVerdict::inconclusive), 0U) << extremes_table(records);
  for (const auto& r : records)
    EXPECT_EQ(verdict_of(r) == ExtremeVerdict::refused, !r.row.refusal.empty()) << r.row.value;
}

// The unexpected answer and the unexpected refusal of real scenes fail.
TEST(ExtremesGuard, ReportsWhatIsNotExpected) {
  auto answers = only_family(extreme_rows(), "length"), refuses = only_family(extreme_rows(), "refused input");
  answers.resize(1);
  refuses.resize(1);
  answers.front().refusal = "Motion / Phase";
  refuses.front().refusal = "";
  EXPECT_EQ(count(run_extremes(answers), ExtremeVerdict::fails), 1U);
  EXPECT_EQ(count(run_extremes(refuses), ExtremeVerdict::fails), 1U);
}

TEST(ExtremesTable, ShowsVerdictsAndCounts) {
  const auto table = extremes_table({record(1e-3, 2e-3), record(1e-3, 2e-2), record(3e-2, 2e-3), refused("a", "a b")});
  EXPECT_NE(table.find("4 scenes: 1 agree, 1 refused as expected, 1 inconclusive, 1 FAIL"), std::string::npos) << table;
  EXPECT_NE(table.find("bar 2.0e-02, mostly rings, tolerance 1e-02"), std::string::npos) << table;
  EXPECT_NE(extremes_junit({record(1e-3, 2e-3), record(3e-2, 2e-3)}).find("tests=\"2\" failures=\"1\""),
            std::string::npos);
}

TEST(ExtremesJson, HasWhatTheReportShows) {
  auto broken = record(not_a_number, infinity);
  broken.row.value = "<broken>";
  const auto json = extremes_json({record(1e-3, 2e-3), broken, refused("a", "a b")});
  EXPECT_EQ(json["summary"]["fail"], 1);
  EXPECT_TRUE(json["scenes"][1]["errors"]["stick_radius_shakedown"]["bar"].is_null());
  EXPECT_EQ(json["scenes"][0]["worst"], "stick_radius_shakedown");
  const auto html = extremes_section(json);
  EXPECT_NE(html.find("&lt;broken&gt;"), std::string::npos) << html;
  EXPECT_NE(html.find("1 fail."), std::string::npos) << html;
}

TEST(FlatMesh, HasFlatCellsAndTheOldBoundary) {
  const BodySpecification specification{{0, 0.25, 0.5, 0.75, 1}, 0.3, 10, 2, true};
  const auto mesh = mesh_of(specification);
  const auto flat = flattened(mesh, 100, 0.25, 1);
  meshes::audit(flat, "flat");
  EXPECT_GT(meshes::quality(flat).max_aspect_ratio, 90);
  EXPECT_LT(meshes::quality(mesh).max_aspect_ratio, 20);
  EXPECT_NEAR(meshes::quality(flat).area, meshes::quality(mesh).area, 1e-6);
}

}  // namespace
}  // namespace fretval
