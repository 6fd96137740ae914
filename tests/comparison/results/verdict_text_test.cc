#include "comparison/results/verdict_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

ordered_json compared(double difference, double tolerance, double bar, const ordered_json& verdict, bool asked = true) {
  return {{"difference", difference}, {"tolerance", tolerance}, {"error_bar", bar}, {"mdr_error", 0},
          {"asked", asked},           {"verdict", verdict},     {"pass", true}};
}

/// A contact of 1.1 mm of which 0.79 mm stick.
ordered_json result(const char* verdict) {
  return {{"name", "case"},
          {"pass", true},
          {"verdict", verdict},
          {"scene", {{"contact_radius_unworn", 1.1e-3}, {"wear", "unworn"}}},
          {"mdr", {{"worn_radius", 1.24e-3}}},
          {"fe",
           {{"contact_radius_max", 1.1e-3},
            {"stick_radius_first_slip", nullptr},
            {"stick_radius_shakedown", 7.9e-4},
            {"lifts_off", false}}},
          {"comparison",
           {{"stick_radius_first_slip", compared(1e-5, 1e-3, 1e-4, "agree")},
            {"stick_radius_shakedown", compared(-6.9e-5, 1e-3, 1e-4, "agree")},
            {"contact_radius_max", compared(1e-6, 1e-4, 1e-5, "agree")}}}};
}

TEST(PlainAnswer, SaysWhatSticksAndHowFarTheRestWears) {
  EXPECT_EQ(plain_answer(result("agree")),
            "the inner 0.790 mm of a contact of 1.10 mm sticks for good; the ring outside wears, out to 1.24 mm");
  auto fresh = result("agree");
  fresh["fe"]["worn_radius"] = 0;
  EXPECT_EQ(plain_answer(fresh), "the inner 0.790 mm of a contact of 1.10 mm sticks for good; the ring outside wears");
  auto all = result("agree");
  all["fe"]["stick_radius_shakedown"] = 1.1e-3;
  EXPECT_EQ(plain_answer(all), "all of the contact of 1.10 mm sticks for good: nothing wears");
}

// MDR's end of the wear is not that of another model; the end that finite elements have found is.
TEST(PlainAnswer, OfAnotherModelHasNoEndOfTheWearByMdr) {
  auto other = result(name_of(Outcome::other_model));
  other["other_model"] = {"friction is a vector"};
  EXPECT_EQ(plain_answer(other), "the inner 0.790 mm of a contact of 1.10 mm sticks for good; the ring outside wears");
  auto worn = result("agree");
  worn["fe"]["worn_radius"] = 1.3e-3;
  worn["fe"]["wear"] = {{"ends_in_limit", true}};
  EXPECT_EQ(
      plain_answer(worn),
      "the inner 0.790 mm of a contact of 1.10 mm sticks for good; the ring outside has worn off, out to 1.30 mm");
  worn["scene"]["wear"] = "limiting";
  EXPECT_EQ(plain_answer(worn), "this worn indenter is pressed, and sticks, within 0.790 mm: nothing wears any more");
}

TEST(PlainAnswer, SaysWhatWearOffTheCircleLeaves) {
  auto worn = result("other model");
  worn["fe"]["surface_wear"] = {{"sticks", {{"radius", 6.6e-4}}}};
  EXPECT_EQ(plain_answer(worn),
            "unworn, the inner 0.790 mm of a contact of 1.10 mm sticks; of the worn indenter the inner 0.660 mm");
}

TEST(PlainAnswer, HasAHeadlineOfItsOwnForEachKindOfContact) {
  auto none = result("agree");
  none["fe"]["stick_radius_shakedown"] = nullptr;
  expect_parts(plain_answer(none), {"nothing sticks for good: all of the contact of 1.10 mm slips in every cycle"});
  none["fe"]["lifts_off"] = true;
  expect_parts(plain_answer(none), {"the indenter lifts off in every cycle"});
  auto pass = result("agree");
  pass["scene"]["path"] = {{"repeats", "once"}};
  EXPECT_EQ(plain_answer(pass), "in this pass all of the contact of 1.10 mm slips");
  pass["fe"]["stick_radius_first_slip"] = 5e-4;
  EXPECT_EQ(plain_answer(pass), "in this pass the inner 0.500 mm of a contact of 1.10 mm never slips");
  auto of_three_digits = pass;
  of_three_digits["fe"]["stick_radius_first_slip"] = 2.206e-4;
  of_three_digits["fe"]["contact_radius_max"] = 3.392e-4;
  EXPECT_EQ(plain_answer(of_three_digits), "in this pass the inner 221 µm of a contact of 339 µm never slips");
  pass["comparison"]["stick_radius_first_slip"]["error_bar"] = 0.06;
  EXPECT_EQ(plain_answer(pass), "in this pass the inner 500 ± 66 µm of a contact of 1.10 mm never slips")
      << "not even its first digit is known";
  pass["scene"]["path"]["from_touch"] = true;
  EXPECT_EQ(plain_answer(pass), "in this pass the contact grows from a touch to 1.10 mm");
  auto sliding = result("agree");
  sliding["mdr"]["gross_slip"] = 0.859;
  sliding["fe"]["gross_slip"] = {{"time", 12}, {"amplitude", 0.933}};
  EXPECT_EQ(plain_answer(sliding), "the whole contact slides: friction does not carry the tangential force");
}

TEST(VerdictSentence, SaysOfWhat) {
  auto some = result("agree");
  EXPECT_EQ(verdict_sentence(some),
            "finite elements confirm the method of dimensionality reduction (MDR): both stick radii and the largest "
            "contact radius agree to 6.9e-05");
  some["comparison"]["friction_work"] = compared(0.2, 1e-4, 0.3, "not resolved", false);
  some["comparison"]["bulk_work"] = compared(1e-4, 1e-3, 2e-4, "agree", false);
  expect_parts(verdict_sentence(some), {" agree to 6.9e-05; 1 of 2 other quantities is not resolved"});
}

TEST(VerdictSentence, OfADisagreementNamesItAndCountsTheRest) {
  auto bad = result("disagree");
  bad["comparison"]["stick_radius_shakedown"] = compared(5e-3, 1e-3, 1e-4, "disagree");
  EXPECT_EQ(
      verdict_sentence(bad),
      "finite elements do not confirm the method of dimensionality reduction (MDR): they differ in the stick radius "
      "(shakedown) by 5.0e-03, where 1e-03 was asked for and the error bar is 1.0e-04. 2 of 3 quantities that were "
      "asked for agree");
}

// The largest use of a tolerance comes first, which is not the largest difference; a fourth one is counted.
TEST(VerdictSentence, OfManyDisagreementsBeginsWithTheWorst) {
  auto bad = result("disagree");
  bad["comparison"]["stick_radius_first_slip"] = compared(5e-3, 1e-3, 1e-4, "disagree");
  bad["comparison"]["stick_radius_shakedown"] = compared(4e-3, 1e-3, 1e-4, "disagree");
  bad["comparison"]["contact_radius_max"] = compared(3e-3, 1e-4, 1e-5, "disagree");
  bad["comparison"]["normal_force_max"] = compared(2e-4, 1e-4, 1e-5, "disagree");
  expect_parts(
      verdict_sentence(bad),
      {"they differ in the largest contact radius by 3.0e-03, where 1e-04 was asked for and the error bar is "
       "1.0e-05; the stick radius (first slip) by 5.0e-03",
       "; the stick radius (shakedown) by 4.0e-03", "; and 1 more. 0 of 4 quantities that were asked for agree"});
  EXPECT_EQ(verdict_sentence(bad).find("largest normal force"), std::string::npos);
}

// Both bars count, and so does a radius that one method alone has: 0.79 mm of 1.1 mm.
TEST(VerdictSentence, OfARadiusThatOneMethodAloneHasSaysSo) {
  auto bad = result("disagree");
  bad["comparison"]["stick_radius_shakedown"] = compared(5e-3, 1e-3, 1e-4, "disagree");
  bad["comparison"]["stick_radius_shakedown"]["difference"] = nullptr;
  expect_parts(verdict_sentence(bad),
               {"they differ in the stick radius (shakedown), which only one of both finds. 2 of 3"});
  for (const auto& one : stored_differences(bad))
    if (one.quantity == Quantity::stick_radius_shakedown) {
      EXPECT_NEAR(one.size, 7.9 / 11, 1e-12);
    }
  bad["comparison"]["contact_radius_max"]["mdr_error"] = 3e-5;
  for (const auto& one : stored_differences(bad))
    if (one.quantity == Quantity::contact_radius_max) {
      EXPECT_NEAR(one.bar, 4e-5, 1e-15);
    }
}

TEST(VerdictSentence, OfWideBarsNeitherConfirmsNorRefutes) {
  auto open = result("not resolved");
  open["comparison"]["contact_radius_max"] = compared(1e-6, 1e-4, 2e-4, "not resolved");
  expect_parts(verdict_sentence(open), {"not resolved: ", "neither confirm nor refute",
                                        "the error bar of the largest contact radius is 2.00e-04, wider than the "
                                        "tolerance of 1e-04 that was asked for (the difference is 1.0e-06)"});
}

// Whatever the difference.
TEST(VerdictSentence, WithoutBarsIsNotProved) {
  auto bare = result("not proved");
  for (auto& [key, one] : bare["comparison"].items()) one["verdict"] = one["error_bar"] = nullptr;
  bare["comparison"]["stick_radius_shakedown"]["difference"] = 0.3;
  expect_parts(verdict_sentence(bare), {"not proved: ", "differ by up to 3.0e-01", "--proof bars or tolerance"});
  EXPECT_EQ(verdict_sentence(bare).find("confirm"), std::string::npos);
}

// Of all amplitudes 81.1 %: so far the balance of forces goes; the methods found it on ramps of their own.
TEST(VerdictSentence, OfGrossSlipHoldsBothToTheBalanceOfForces) {
  auto sliding = result("agree");
  sliding["fe"]["gross_slip"] = {{"time", 12}, {"amplitude", 0.933}};
  sliding["mdr"]["gross_slip"] = 0.859;
  sliding["mdr"]["steady_sliding_share"] = 0.8111;
  expect_parts(verdict_sentence(sliding),
               {"finite elements find it after 12.0000 s, at 93.3 % of the amplitudes", "finds it at 85.9 % of them",
                "the steady motion slides from 81.1 % of the amplitudes on: this one is 23.3 % beyond"});
}

// Friction carries 99.98 % of the amplitudes, says one of the methods.
TEST(VerdictSentence, OfGrossSlipByOneMethodAloneSaysWhichOne) {
  auto sliding = result("not resolved");
  sliding["mdr"]["gross_slip"] = 0.99983;
  EXPECT_EQ(verdict_sentence(sliding),
            "finite elements do not find that, the method of dimensionality reduction (MDR) finds it at 99.98 % of the "
            "amplitudes");
  EXPECT_EQ(plain_answer(sliding),
            "the whole contact slides by MDR alone: friction just carries the tangential force, or just does not");
  sliding = result("disagree");
  sliding["fe"]["gross_slip"] = {{"time", 12}, {"amplitude", 0.5}};
  EXPECT_EQ(plain_answer(sliding), "the whole contact slides by finite elements alone");
}

// A pass slides from an instant on, not from an amplitude; each method has its own.
TEST(VerdictSentence, OfAPassThatSlidesHasTheInstants) {
  auto sliding = result("agree");
  sliding["fe"]["gross_slip"] = {{"time", 0.5}, {"amplitude", 0.933}};
  sliding["mdr"]["gross_slip"] = 0.7;
  sliding["mdr"]["gross_slip_time"] = 0.25;
  EXPECT_EQ(
      verdict_sentence(sliding),
      "finite elements find it from t = 500.000 ms on, the method of dimensionality reduction (MDR) finds it from "
      "t = 250.000 ms on");
}

// Only MDR has a first-slip radius, and only the case one of shakedown.
TEST(VerdictSentence, OfAnotherModelSaysWhichZoneOneAloneHas) {
  auto other = result(name_of(Outcome::other_model));
  other["other_model"] = {"friction is a vector"};
  other["mdr"]["stick_radius_first_slip"] = 3e-4;
  other["mdr"]["contact_radius_max"] = 1.1e-3;
  expect_parts(verdict_sentence(other),
               {"the stick radius (first slip) only MDR has, ", "the stick radius (shakedown) only the case has"});
}

TEST(VerdictSentence, WhereNothingIsComparedSaysSo) {
  auto none = result("not compared");
  none["not_compared"] = nlohmann::ordered_json::object();
  EXPECT_EQ(verdict_sentence(none), "");
  none["comparison"] = nlohmann::ordered_json::object();
  EXPECT_EQ(verdict_sentence(none), "nothing is compared with the method of dimensionality reduction (MDR)");
}

// 7.9e-4 m over 6.32e-4 m and 1.1 mm over 1.375 mm of MDR; bars of 1 % of 1.1 mm are of these as much.
TEST(VerdictSentence, OfAnotherModelSaysHowFarMdrIsOffFromItsOwnValue) {
  auto other = result(name_of(Outcome::other_model));
  other["other_model"] = {"the body is a cylinder", "friction is a vector"};
  other["mdr"]["stick_radius_shakedown"] = 6.32e-4;
  other["mdr"]["contact_radius_max"] = 1.375e-3;
  for (const char* key : {"stick_radius_shakedown", "contact_radius_max"})
    other["comparison"][key] = compared(0.1, 1e-3, 0.01, nullptr);
  expect_parts(verdict_sentence(other),
               {"computes another model, as the body is a cylinder, friction is a vector: compared with it, ",
                "25 % ± 2 % larger", "20 % ± 0.8 % smaller"});
}

// Of a rate that differs by a fifth the verdict says nothing of the radii.
TEST(VerdictSentence, LeavesTheDecayOfSlipOutOfTheSize) {
  auto some = result("agree");
  some["comparison"]["slip_decay"] = compared(0.2, 0.5, 0.3, "agree");
  expect_parts(verdict_sentence(some), {" agree to 6.9e-05"});
}

// pass, fail and inconclusive; nobody said what was asked for.
TEST(StoredOutcome, OfTheFirstVersionIsUnderstood) {
  auto old = stored_result();
  for (const char* key : {"verdict", "schema"}) old.erase(key);
  EXPECT_EQ(stored_outcome(old), Outcome::agree);
  old["pass"] = false;
  old["comparison"]["normal_force_max"]["verdict"] = "inconclusive";
  EXPECT_EQ(stored_outcome(old), Outcome::not_resolved);
  old["comparison"]["normal_force_max"]["verdict"] = "fail";
  EXPECT_EQ(stored_outcome(old), Outcome::disagree);
}

}  // namespace
}  // namespace fretval
