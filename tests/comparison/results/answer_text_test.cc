#include "comparison/results/answer_text.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

std::string answer_to(const CaseResult& result) {
  return answer_text(result, result_json(result));
}

TEST(AnswerText, ShowsAsManyDigitsAsTheBarAllows) {
  EXPECT_EQ(with_unit(6.92107e-4, 4.3e-8, "m"), "692.11 ± 0.04 µm");
  EXPECT_EQ(with_unit(0.83377217, 6e-5, "N"), "833.77 ± 0.06 mN");
  EXPECT_EQ(with_unit(12.6, 3, "N"), "13 ± 3 N");
  EXPECT_EQ(with_unit(1.1165058563648615e-3, 0, "m"), "1.11651 mm");
  EXPECT_EQ(with_unit(2.5e4, 0, "N"), "25.0000 kN");
  EXPECT_EQ(with_unit(0, 0, "N"), "0 nN");
  EXPECT_EQ(with_unit(0, 2e-10, "m"), "0.0 ± 0.2 nm");
  EXPECT_EQ(with_unit(5.43573e-4, 9.7e-9, "m"), "543.57 ± 0.01 µm");
  EXPECT_EQ(with_unit(5.43573e-4, 9.4e-9, "m"), "543.573 ± 0.009 µm");
  EXPECT_EQ(with_unit(-9.06e-5, 4.17e-4, "N"), "-0.1 ± 0.4 mN");
  EXPECT_EQ(with_unit(-9.06e-5, 1.17e-3, "N"), "0 ± 1 mN");
  EXPECT_EQ(with_unit(-3e-10, 7.84e-7, "N"), "0.0 ± 0.8 µN");
  EXPECT_EQ(with_unit(0.11109, 1e-17, "N"), "111.090 mN");
}

// The numbers of the made-up result: a bar of 0.03125 of the force of 42.5 N; the shakedown radius has none and fails.
TEST(AnswerText, SetsFiniteElementsBesideMdr) {
  const auto text = answer_to(made_up_result());
  expect_parts(text, {"case: finite elements do not confirm MDR: they differ by up to 1.5e-01",
                      "stick radius, shakedown      750.000 mm                   600.000 µm",
                      "largest normal force         42 ± 1 N                     40.0000 N", "1.90000 m"});
  EXPECT_EQ(text.find("first slip"), std::string::npos) << "not compared";
}

TEST(AnswerText, SaysWhatTheVerdictIs) {
  auto result = made_up_result();
  result.comparison.erase(Quantity::stick_radius_shakedown);
  expect_parts(answer_to(result), {"case: finite elements confirm MDR to 6.2e-02"});
  result.comparison.at(Quantity::normal_force_max).verdict = Verdict::inconclusive;
  expect_parts(answer_to(result), {"case: open", "wider than the tolerance"});
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

// Of a rate that differs by a fifth the verdict is a pass; it says nothing of the radii.
TEST(AnswerText, LeavesTheDecayOfSlipOutOfTheSentence) {
  auto json = stored_result();
  json["comparison"]["slip_decay"] = {
      {"difference", 0.2}, {"tolerance", 0.5}, {"error_bar", 0.3}, {"verdict", "pass"}, {"pass", true}};
  EXPECT_EQ(answer_of(json).verdict, answer_of(stored_result()).verdict);
  EXPECT_EQ(answer_of(json).verdict.find("e-01"), std::string::npos);
}

}  // namespace
}  // namespace fretval
