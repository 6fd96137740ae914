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
  result.half_space->normal_force_max = 42.5 * (1 + 1e-12);  // prescribed
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

/// How wear can end, and what is said of it.
struct HowItEnds {
  fem::WearEnd end;
  double pressed_outside;
  bool slip_is_proved, sticks_throughout;
  const char* words;
};

// A cycle takes 2 s. What springs have worn off stands beside the last of the finite elements' volumes.
TEST(AnswerText, SaysHowTheWearHasEnded) {
  auto result = made_up_result();
  auto json = result_json(result);
  json["scene"]["frequency"] = json["scene"]["tangential_frequency"] = 0.5;
  const auto limit = wear_limit(mdr::limiting_profile(mdr::parabola(1e-2), 5e-4, 1e-4));
  for (const auto& one :
       {HowItEnds{fem::WearEnd::rate, 0, true, false, "; nothing wears any more\n  worn profile: 2.0e-02 from the"},
        HowItEnds{fem::WearEnd::rate, 0.5, true, false, "; still 0.02 from the limiting profile\n"},
        HowItEnds{fem::WearEnd::nothing_left, 0.5, true, false, "still bears pressure sticks throughout, and wears no"},
        HowItEnds{fem::WearEnd::cycles, 0, false, true, "; all that touches sticks: nothing wears\n"},
        HowItEnds{fem::WearEnd::cycles, 0, false, false, "; no slip is proved: friction takes less energy"}}) {
    ProvedWear wear{{}, {}, {}, {limit, limit}};
    wear.fe.course.curve = {{0, 0, 2, 3, 0, 1, 0.5}, {1e6, 0.25, 0.5, 1, 0.2, 1, 0.5}};
    wear.fe.course.end = one.end;
    wear.pressed_outside = one.pressed_outside;
    wear.slip_is_proved = one.slip_is_proved;
    wear.sticks_throughout = one.sticks_throughout;
    wear.distance_shakedown = {0.3, 0.02};
    wear.distance_first_slip = {0.4, 0.07};
    wear.kinetics = mdr::WearKinetics{{{0, 1e-9, 0, 0, 0, 0}, {1e6, 3e-9, 0, 0, 0, 0}}, {}, {}, {}};
    result.wear = wear;
    expect_parts(answer_text(result, json),
                 {"worn off: 5e+08 mm³ in 1e+06 cycles, 23.1 days at 0.5 Hz (MDR 3 mm³)", one.words});
  }
}

/// Of which 0.25 sticks, 0.35 of it along x and 0.15 across, each with a bar.
ProvedSurfaceWear worn_off_the_circle() {
  ProvedSurfaceWear wear{{}, {}, {}, wear_limit(mdr::limiting_profile(mdr::parabola(1e-2), 5e-4, 1e-4))};
  wear.limit.volume = 7e-9;
  wear.fe.course.curve = {{0, 0, 2, 3, 0, 1, 0.5}, {1e6, 0.25, 0.5, 1, 0.2, 1, 0.5}};
  wear.fe.course.end = fem::WearEnd::nothing_left;
  wear.fe.sticks.radius = 0.25;
  wear.fe.sticks.along = 0.35;
  wear.fe.sticks.across = 0.15;
  wear.radius.add(ErrorSource::rings, 0.01);
  wear.along.add(ErrorSource::rings, 0.02);
  wear.across.add(ErrorSource::rings, 0.03);
  return wear;
}

// A length of 1 is 2 m, a volume of 1 is 2 m³; bars are shares of the length.
TEST(AnswerText, SaysWhatWearOffTheCircleLeavesToStickInEachDirection) {
  auto result = made_up_result();
  const auto json = result_json(result);
  result.surface_wear = worn_off_the_circle();
  expect_parts(
      answer_text(result, json),
      {"worn off: 5e+08 mm³ in 1e+06 cycles, 11.6 days at 1 Hz (MDR's limit: 7 mm³); nothing wears any more\n",
       "  what has worn leaves 500.000 mm to stick (MDR 500.000 µm), 700.000 mm along x and 300.000 mm across"});
  result.surface_wear->is_proved = true;
  result.surface_wear->fe.course.end = fem::WearEnd::cycles;
  expect_parts(answer_text(result, json),
               {"(MDR's limit: 7 mm³)\n  what has worn leaves 500 ± 20 mm to stick (MDR 500.000 µm), 700 ± 40 mm along "
                "x and 300 ± 60 mm across\n"});
  result.surface_wear->fe.course.end = fem::WearEnd::slides;
  expect_parts(answer_text(result, json), {"(MDR's limit: 7 mm³); then the whole contact slides: μ times"});
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

// A bar of 0.12 of the 1e-6 J of sliding is 1.2 of an energy of 1e-7 J. Of a pressure, which no Cycle tolerance
// refines, nothing is remarked.
TEST(AnswerText, SaysSoWhereABarIsJustWiderThanItsEnergy) {
  auto json = stored_result();
  json["scene"].erase("sweep");
  json["fe"]["friction_work"] = 1e-7;
  json["fe"]["axis_pressure_max"] = 1e5;
  json["fe"]["sliding_work"] = 1e-6;
  json["fe"]["sliding_force"] = 1;
  for (const char* key : {"friction_work", "axis_pressure_max"})
    json["comparison"][key] = {{"difference", 1e-3}, {"tolerance", 1e-3}, {"error_bar", 0.12}, {"mdr_error", 0},
                               {"verdict", "agree"}, {"asked", false},    {"pass", true}};
  const auto answer = answer_of(json);
  for (const auto& row : answer.rows) {
    if (row.title == traits_of(Quantity::friction_work).title) {
      EXPECT_EQ(row.remark, "no larger than its bar");
    }
    if (row.title == traits_of(Quantity::axis_pressure_max).title) {
      EXPECT_EQ(row.remark, "") << row.fe;
    }
  }
  EXPECT_EQ(answer.rows.back().title, std::string("energy lost to friction"));
}

// The line names the entry to set, unless the case has set it.
TEST(AnswerText, NamesTheCycleToleranceWhereThereIsNone) {
  auto json = stored_result();
  json["scene"].erase("sweep");
  json["fe"]["friction_work"] = 1e-7;
  json["fe"]["sliding_work"] = 1e-6;
  json["comparison"]["friction_work"] = {{"difference", 1e-3}, {"tolerance", 1e-3},  {"error_bar", 1e-4},
                                         {"mdr_error", 0},     {"verdict", "agree"}, {"asked", false},
                                         {"pass", true}};
  json["scene"]["inputs"] = {{{"section", "Accuracy"}, {"name", "Tolerance"}, {"value", 1e-3}, {"unit", ""}}};
  expect_parts(kept_answer_text(json), {"known (Accuracy / Cycle tolerance asks for forces and energies):\n"});
  json["scene"]["inputs"].push_back(
      {{"section", "Accuracy"}, {"name", "Cycle tolerance"}, {"value", 1e-3}, {"unit", ""}});
  expect_parts(kept_answer_text(json), {"  not asked for, as far as they are known:\n"});
}

/// Of a profile with more falls than are listed, whose springs are off by 1/8 and -1/16 at rest.
nlohmann::ordered_json result_beyond_mdr() {
  auto json = stored_result();
  json["scene"].erase("sweep");
  auto falls = nlohmann::ordered_json::array();
  for (int k = 0; k < 5; ++k) falls.push_back({{"from", k * 1e-4}, {"to", k * 1e-4 + 5e-5}});
  json["not_compared"] = {{"image_falls", falls},
                          {"at_rest", {{"normal_force_difference", 0.125}, {"contact_radius_difference", -0.0625}}}};
  json["comparison"] = nlohmann::ordered_json::object();
  json["fe"]["normal_force_max"] = 2;
  json["fe"]["contact_radius_max"] = 1e-3;
  json["fe"]["error_estimate"] = {{"normal_force_max", {{"total", 0.05}}}};
  const auto annulus = [](double inner, double outer) {
    return nlohmann::ordered_json::array(
        {{{"inner", inner}, {"outer", outer}, {"inner_bar", nullptr}, {"outer_bar", 1e-6}}});
  };
  json["fe"]["zones"] = {{"contact", annulus(0, 1e-3)},
                         {"first_slip", annulus(0, 4e-4)},
                         {"shakedown", annulus(2e-4, 6e-4)},
                         {"pressure_max", 2e5},
                         {"pressure_max_bar", 1e3}};
  return json;
}

TEST(AnswerText, BeyondMdrHasTheZonesWithTheirBars) {
  expect_parts(
      kept_answer_text(result_beyond_mdr()),
      {"g(x) falls for x = 0 to 50 µm, 100 µm to 150 µm, 200 µm to 250 µm and in 2 places more. At rest at the "
       "largest indentation its springs would be off by +12 % of the normal force and -6.2 % of the contact "
       "radius\n",
       "  largest normal force         2.0 ± 0.1 N\n", "  largest pressure             200 ± 1 kPa\n",
       "  contact, r                   0 to 1.000 ± 0.001 mm\n", "  stick, first slip, r         0 to 400 ± 1 µm\n",
       "  stick, shakedown, r          200.000 µm to 600 ± 1 µm\n"});
  EXPECT_EQ(kept_answer_text(result_beyond_mdr()).find("largest contact radius"), std::string::npos) << "without a bar";
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

// Cycles of several frequencies have no length of their own.
TEST(AnswerText, SaysNoTimeOfCyclesOfSeveralFrequencies) {
  auto json = stored_result("single");
  json["scene"]["frequency"] = 1;
  json["scene"]["tangential_frequency"] = 2;
  json["fe"]["surface_wear"] = {{"cycles", {0, 36000}}, {"volume", {0, 2e-12}}, {"sticks", {{"radius", 1e-4}}}};
  expect_parts(kept_answer_text(json), {"worn off: 0.002 mm³ in 3.6e+04 cycles\n"});
  json["scene"]["tangential_frequency"] = 1;
  expect_parts(kept_answer_text(json), {"in 3.6e+04 cycles, 10 h at 1 Hz\n"});
  json["scene"]["normal_harmonics"] = nlohmann::ordered_json::array();
  expect_parts(kept_answer_text(json), {"in 3.6e+04 cycles\n"});
}

TEST(AnswerText, SaysByHowMuchASecondAlgorithmDiffers) {
  auto json = stored_result("single");
  json["fe"]["zones"] = {{"contact", nlohmann::ordered_json::array()}};
  EXPECT_EQ(kept_answer_text(json).find("second algorithm"), std::string::npos);
  json["fe"]["zones"]["second_algorithm"] = 3.4e-8;
  expect_parts(kept_answer_text(json), {"  second algorithm             differs by 3.4e-08           of the largest"});
}

// What springs step to the last digits is no change.
TEST(AnswerOfStoredResult, HasNoRoundoffInItsSensitivity) {
  auto result = stored_result();
  result["mdr"]["sensitivity"] = {
      {"stick_radius_first_slip", {{"friction_coefficient", 0.31}, {"relaxed_modulus", -3e-9}}},
      {"stick_radius_shakedown", nullptr}};
  EXPECT_EQ(answer_of(result).sensitivity,
            "1 % more friction (μ) changes the stick radius, first slip by +0.31 %; 1 % more relaxed modulus (G'(0), "
            "the branches as they are) changes the stick radius, first slip by +0 %");
}

}  // namespace
}  // namespace fretval
