#include "comparison/results/answer_text.h"

#include <gtest/gtest.h>

#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

std::string answer_to(const CaseResult& result) {
  return answer_text(result, result_json(result));
}

// The numbers of the made-up result: a bar of 0.03125 of the force of 42.5 N; the shakedown radius disagrees.
TEST(AnswerText, SetsFiniteElementsBesideMdr) {
  const auto text = answer_to(made_up_result());
  expect_parts(text, {"case: the inner 0.750 m of a contact of 1.25 m sticks for good; the ring outside wears",
                      "finite elements do not confirm the method of dimensionality reduction (MDR): they differ in the "
                      "stick radius (shakedown) by 1.5e-01",
                      "stick radius, shakedown      750.000 mm                   600.000 µm               disagree",
                      "largest normal force         42 ± 1 N                     40.0000 N", "1.90000 m"});
  EXPECT_EQ(text.find("first slip"), std::string::npos) << "not compared";
}

// 0.5 of 0.75 m and 1 of 1.25 m.
TEST(AnswerText, SaysWhatAHalfSpaceWouldHaveInThePlaceOfALayer) {
  auto result = made_up_result();
  EXPECT_EQ(answer_to(result).find("half-space"), std::string::npos);
  result.half_space.emplace();
  result.half_space->contact_radius_max = 1;
  result.half_space->stick_radius_shakedown = 0.5;
  expect_parts(answer_to(result),
               {"over a half-space MDR would be off: stick radius, shakedown by -33.3 %, largest contact "
                "radius by -20 %\n"});
}

// A volume of 1 is 2 m³ here: a quarter of it has gone, and half of it goes in each cycle.
TEST(AnswerText, SaysHowMuchHasWornAndWearsOn) {
  auto result = made_up_result();
  const auto json = result_json(result);
  const auto limit = wear_limit(mdr::limiting_profile(mdr::parabola(1e-2), 5e-4, 1e-4));
  ProvedWear wear{{}, {}, {}, {limit, limit}};
  wear.fe.course.curve = {{0, 0, 2, 3, 0, 1, 0.5}, {1e6, 0.25, 0.5, 1, 0.2, 1, 0.5}};
  wear.fe.course.end = fem::WearEnd::progressive;
  wear.rate_error = 0.1;
  result.wear = wear;
  expect_parts(answer_text(result, json),
               {"worn off: 5e+08 mm³ in 1e+06 cycles", "it goes on for ever, by 1e+09 mm³ a cycle (± 0.1 of that)"});
  result.wear->fe.course.end = fem::WearEnd::slides;
  expect_parts(answer_text(result, json),
               {"in 1e+06 cycles, 11.6 days at 1 Hz; then the whole contact slides: μ times"});
}

TEST(AnswerText, SetsWhatWasNotAskedForApart) {
  auto result = made_up_result();
  result.comparison.erase(Quantity::stick_radius_shakedown);
  EXPECT_EQ(answer_to(result).find("not asked for"), std::string::npos);
  result.comparison[Quantity::axis_pressure_max] = {0.25, 0.125, Verdict::not_resolved, ErrorBar{}, 0, false};
  const auto text = answer_to(result);
  EXPECT_LT(text.find("largest normal force "), text.find("not asked for"));
  EXPECT_LT(text.find("not asked for"), text.find("largest pressure on the axis"));
  expect_parts(text, {"12.0 ± 0.1 Pa            not resolved\n"});
}

// An energy that finite elements know to half of it, unasked.
TEST(AnswerText, SaysWhatToSetWhereAnEnergyIsHardlyKnown) {
  auto json = stored_result();
  json["scene"].erase("sweep");
  json["fe"]["friction_work"] = 1e-7;
  json["fe"]["sliding_work"] = 1e-6;
  json["comparison"]["friction_work"] = {{"difference", 1e-3}, {"tolerance", 1e-3},         {"error_bar", 0.05},
                                         {"mdr_error", 0},     {"verdict", "not resolved"}, {"asked", false},
                                         {"pass", true}};
  expect_parts(kept_answer_text(json),
               {"energy lost to friction", "not resolved; known to 50 %: set a Cycle tolerance"});
  json["fe"]["friction_work"] = 1e-8;
  expect_parts(kept_answer_text(json), {"energy lost to friction", "not resolved; no larger than its bar"});
}

TEST(AnswerText, OfAListOfManyAnnuliHasTheFirst) {
  nlohmann::ordered_json annuli = nlohmann::ordered_json::array();
  for (int k = 1; k <= 9; ++k)
    annuli.push_back({{"inner", 2e-6 * k}, {"outer", 2e-6 * k + 1e-6}, {"inner_bar", nullptr}, {"outer_bar", nullptr}});
  expect_parts(annuli_text(annuli), {"2.00000 µm to 3.00000 µm; ", "; and 6 more, out to 19.0000 µm"});
}

// Of a prescribed force both have the largest exactly, and a mean of 0 but for roundoff. Springs say what they are off
// by.
TEST(AnswerText, ShowsTheErrorOfSpringsAndNoRoundoff) {
  const nlohmann::ordered_json mdr{{"tangential_force_max", 0.05},
                                   {"tangential_force_mean", 1.7e-17},
                                   {"uncertainty", {{"tangential_force_max", 2e-17}}}};
  const Scales scales{1e-3, 0.3, 1e-6};
  EXPECT_EQ(mdr_text(mdr, Quantity::tangential_force_mean, scales), "0 nN");
  EXPECT_EQ(mdr_text(mdr, Quantity::tangential_force_max, scales), "50.0000 mN");
  const nlohmann::ordered_json settling{{"cycles_to_shakedown", 11.885},
                                        {"uncertainty", {{"cycles_to_shakedown", 0.08}}}};
  EXPECT_EQ(mdr_text(settling, Quantity::cycles_to_shakedown, scales), "11.88 ± 0.08 cycles");
}

TEST(AnswerOfStoredResult, SaysHowGoodMdrIsAsAModel) {
  auto result = stored_result();
  EXPECT_EQ(answer_of(result).model, "");
  result["model"] = {{"good_to", 0.031},
                     {"mdr_off_by",
                      {{"stick_radius_first_slip", {{"value", 0.021}, {"uncertainty", 0.004}}},
                       {"stick_radius_shakedown", {{"value", 0.002}, {"uncertainty", 0.003}}}}}};
  EXPECT_EQ(answer_of(result).model,
            "as a model MDR is good to about 3 %: off by +2.1 ± 0.4 % in the stick radius, first slip");
  result["model"] = {{"good_to", 0.123},
                     {"mdr_off_by",
                      {{"stick_radius_first_slip", {{"value", -1.234}, {"uncertainty", 0.0972}}},
                       {"stick_radius_shakedown", {{"value", 0.996}, {"uncertainty", 0.31}}}}}};
  EXPECT_EQ(answer_of(result).model,
            "as a model MDR is good to about 12 %: off by -123 ± 10 % in the stick radius, first slip; +100 ± 31 % in "
            "the stick radius, shakedown");
  result["model"] = {{"good_to", nullptr}, {"outside", "the maps are of an unworn indenter"}};
  EXPECT_EQ(answer_of(result).model, "as a model: outside the map (the maps are of an unworn indenter)");
}

// 36000 cycles of a second.
TEST(AnswerText, SaysHowLongTheWearTakes) {
  auto json = stored_result("single");
  json["scene"]["frequency"] = 1;
  json["fe"]["wear"] = {{"cycles", {0, 36000}}, {"volume", {0, 2e-12}}};
  expect_parts(kept_answer_text(json), {"in 3.6e+04 cycles, 10 h at 1 Hz\n"});
}

}  // namespace
}  // namespace fretval
