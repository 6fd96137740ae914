#include "comparison/report/sections/values_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

StoredResult with_radius(const std::string& family, double value, const nlohmann::ordered_json& fe, double mdr,
                         double bar) {
  auto json = stored_result();
  json["name"] = family + "/" + fmt::format("{}", value);
  json["scene"]["sweep"] = {{"family", family}, {"entry", "Friction / Coefficient"}, {"value", value}};
  json["scene"]["contact_radius_unworn"] = 1;
  json["fe"]["stick_radius_shakedown"] = fe;
  json["mdr"]["stick_radius_shakedown"] = mdr;
  json["comparison"]["stick_radius_shakedown"]["error_bar"] = bar;
  return {json, {}};
}

const std::vector<Quantity> radius_alone{Quantity::stick_radius_shakedown};

TEST(ValuesTable, HasTheEndsOfASweepWithTheirBars) {
  const auto text =
      text_of(values_table({with_radius("mine", 1, 0.25, 0.25, 1e-3), with_radius("mine", 2, 0.5, 0.5, 2e-3),
                            with_radius("mine", 3, 0.375, 0.375, 1e-3)},
                           radius_alone));
  expect_parts(text, {"mine, 3 cases\n", "  stick radius, shakedown  250 ± 1 to 500 ± 2 mm  250.000 to 500.000 mm"});
}

// Springs that were stepped for an energy are off by something, too.
TEST(ValuesTable, HasTheErrorsOfSprings) {
  auto json = stored_result("single");
  json["fe"]["friction_work"] = json["mdr"]["friction_work"] = 2e-7;
  json["mdr"]["uncertainty"] = {{"friction_work", 1e-9}};
  json["comparison"]["friction_work"] = {
      {"difference", 0.0}, {"tolerance", 1e-3}, {"error_bar", nullptr}, {"verdict", "pass"}, {"pass", true}};
  expect_parts(text_of(values_table({StoredResult{json, {}}}, {Quantity::friction_work})), {"200.000 nJ  200 ± 1 nJ"});
}

TEST(ValuesTable, SaysWhereNothingSticks) {
  const auto text = text_of(values_table(
      {with_radius("mine", 1, nullptr, 0.25, 1e-3), with_radius("mine", 2, 0.5, 0.5, 2e-3)}, radius_alone));
  expect_parts(text, {"none to 500 ± 2 mm"});
}

TEST(ValuesTable, HasOneValueWhereASweepChangesNothing) {
  const auto text = text_of(
      values_table({with_radius("mine", 1, 0.5, 0.5, 1e-3), with_radius("mine", 2, 0.5002, 0.5, 1e-3)}, radius_alone));
  expect_parts(text, {"  500 ± 1 mm  500.000 mm"});
}

TEST(ValuesTable, HasOneValueWhereASweepChangesLessThanItsBar) {
  const auto text = text_of(
      values_table({with_radius("mine", 1, 0.5, 0.5, 1e-3), with_radius("mine", 2, 0.5009, 0.5, 1e-3)}, radius_alone));
  expect_parts(text, {"  501 ± 1 mm  500.000 mm"});
}

TEST(ValuesTable, HasTheQuantitiesOfUpToEightFamilies) {
  std::vector<StoredResult> results;
  for (int k = 0; k < 8; ++k) results.push_back(with_radius(fmt::format("family {}", k), 1, 0.25, 0.25, 1e-3));
  EXPECT_EQ(values_table(results, radius_alone).rows.size(), 16U) << "a head and a row each";
}

// Stick radii stand for a sweep; where nothing sticks in any of it, the contact does.
TEST(ValuesTable, HasTheContactOfASweepWhereNothingSticks) {
  auto sticks = with_radius("mine", 1, 0.5, 0.5, 1e-3);
  EXPECT_EQ(text_of(sweep_rows({sticks})).find("contact radius"), std::string::npos);
  for (const char* side : {"fe", "mdr"})
    for (const char* key : {"stick_radius_first_slip", "stick_radius_shakedown"}) sticks.json[side][key] = nullptr;
  const auto text = text_of(sweep_rows({sticks}));
  EXPECT_EQ(text.find("stick radius"), std::string::npos) << text;
  expect_parts(text, {"normal force"});
}

TEST(ValuesTable, HasNothingForRoundoff) {
  const auto text = text_of(values_table(
      {with_radius("mine", 1, 1e-14, -1e-17, 1e-3), with_radius("mine", 2, -1e-14, 3e-17, 1e-3)}, radius_alone));
  expect_parts(text, {"  0 nm", "  0 ± 1 mm"});
}

TEST(ValuesTable, OfManyFamiliesHasARowEach) {
  std::vector<StoredResult> results;
  for (int k = 0; k < 9; ++k) results.push_back(with_radius(fmt::format("family {}", k), 1, 0.25, 0.25, 1e-3));
  const auto table = values_table(results, quantities_with_units());
  EXPECT_EQ(table.rows.size(), 9U);
  expect_parts(text_of(table), {"stick radius, shakedown  finite elements", "family 8", "250 ± 1 mm"});
}

TEST(ValuesTable, NamesGrossSlip) {
  auto slides = with_radius("mine", 1, nullptr, 0.25, 1e-3);
  slides.json["comparison"] = nlohmann::ordered_json::object();
  slides.json["fe"]["gross_slip"] = {{"time", 1}, {"amplitude", 0.5}};
  expect_parts(text_of(values_table({slides}, radius_alone)), {"mine  all of the contact slides    –"});
}

TEST(ValuesTable, TakesWhatFiniteElementsSayAlone) {
  auto alone = with_radius("mine", 1, 0.5, 0.25, 1e-3);
  alone.json["comparison"] = nlohmann::ordered_json::object();
  alone.json["not_compared"] = {{"reason", ""}};
  alone.json["fe"]["error_estimate"] = {{"stick_radius_shakedown", {{"total", 2e-3}}}};
  expect_parts(text_of(values_table({alone}, radius_alone)), {"  stick radius, shakedown       500 ± 2 mm    –"});
}

TEST(ValuesTable, HasMoreQuantitiesOnAPageThanOnATerminal) {
  EXPECT_GT(quantities_with_units().size(), main_quantities().size());
}

// A row for each value, in the units of the entry.
TEST(ValuesTable, HasARowForEachValueOfASweep) {
  const auto at = [](double value) {
    auto json = stored_result();
    json["scene"]["sweep"] = {{"family", "family"}, {"entry", "Motion / Indentation"}, {"value", value}};
    return StoredResult{json, {}};
  };
  const auto text = text_of(sweep_rows({at(1e-4), at(2e-4)}));
  EXPECT_EQ(text.find("Motion / Indentation  stick radius, first slip"), 0U) << text;
  expect_parts(text, {"\n100 µm ", "\n200 µm "});
}

}  // namespace
}  // namespace fretval
