#include "comparison/command_line/terminal.h"

#include <gtest/gtest.h>

#include <string>

#include "comparison/support/json.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

BatchLine line_with(const std::string& name, std::optional<double> difference, Outcome outcome) {
  const nlohmann::ordered_json compared{{"difference", or_null(difference)}, {"tolerance", 1e-3}};
  return {name, outcome, "",
          largest_use({{"name", name},
                       {"scene", {{"contact_radius_unworn", 1}}},
                       {"fe", nlohmann::ordered_json::object()},
                       {"mdr", nlohmann::ordered_json::object()},
                       {"comparison", {{"stick_radius_shakedown", compared}}}})};
}

BatchLine failed(const std::string& name) {
  return {name, Outcome::not_proved, "the pump is broken", {}};
}

std::string verdicts_of(const std::vector<BatchLine>& lines) {
  testing::internal::CaptureStdout();
  print_verdicts(lines);
  return testing::internal::GetCapturedStdout();
}

TEST(Outcome, IsALineOfTheLog) {
  auto good = line_with("family/1", 1e-4, Outcome::agree);
  good.seconds = 1.23;
  EXPECT_EQ(outcome_text(good), "family/1: agrees in 1.2 s");
  EXPECT_EQ(outcome_text(line_with("family/2", 2e-3, Outcome::disagree)), "family/2: DISAGREES in 0.0 s");
  EXPECT_EQ(outcome_text(line_with("family/2", 2e-3, Outcome::not_resolved)),
            "family/2: not resolved to the tolerance that was asked for, in 0.0 s");
  EXPECT_EQ(outcome_text(line_with("family/2", 2e-3, Outcome::not_proved)),
            "family/2: not proved, without error bars, in 0.0 s");
  EXPECT_EQ(outcome_text(failed("family/3")), "family/3: FAILED: the pump is broken");
}

TEST(Verdicts, NameTheLargestUseOfAToleranceOfEachFile) {
  const auto text = verdicts_of({line_with("one/a", 2e-4, Outcome::agree), line_with("one/b", -5e-4, Outcome::agree),
                                 line_with("two/a", 1e-5, Outcome::agree)});
  EXPECT_NE(
      text.find(
          "2 of   2 agree; closest to its tolerance: stick radius, shakedown in one/b, off by 5.0e-04 of 1.0e-03"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("stick radius, shakedown in two/a, off by 1.0e-05"), std::string::npos) << text;
  EXPECT_EQ(text.find("DISAGREE"), std::string::npos) << text;
}

// With wide bars nobody can say that they disagree, without bars not even that they agree.
TEST(Verdicts, AreNoWorseAndNoBetterThanWhatIsKnown) {
  const auto open = line_with("one/a", 2e-4, Outcome::not_resolved), good = line_with("one/b", 2e-4, Outcome::agree),
             bad = line_with("one/c", 2e-3, Outcome::disagree), bare = line_with("one/d", 2e-3, Outcome::not_proved);
  expect_parts(verdicts_of({open, good}), {"not resolved one ", "  1 of   2 agree, 1 not resolved"});
  expect_parts(verdicts_of({open, bad}), {"DISAGREE     one ", "  0 of   2 agree, 1 disagree, 1 not resolved"});
  expect_parts(verdicts_of({bare, good}),
               {"not proved   one ", "  1 of   2 agree, 1 not proved; closest to its tolerance", "in one/b"});
  EXPECT_EQ(verdicts_of({bare}).find("tolerance"), std::string::npos) << "what is not proved is held to none";
}

// Beyond MDR's model a difference is no disagreement, and small ones confirm nothing.
TEST(Verdicts, OfAnotherModelSayByHowMuchMdrIsOff) {
  const auto other = line_with("one/a", 7e-2, Outcome::other_model), good = line_with("one/b", 2e-4, Outcome::agree);
  expect_parts(verdicts_of({other}),
               {"other model  one ", "MDR computes another model in 1; MDR is off most: stick radius"});
  EXPECT_EQ(verdicts_of({other}).find("agree"), std::string::npos);
  expect_parts(verdicts_of({other, good}),
               {"agree        one ", "  1 of   1 agree, MDR computes another model in 1; "});
}

TEST(Verdicts, ComeAfterTheValues) {
  auto line = line_with("family/1", 1e-4, Outcome::agree);
  line.json = stored_result().dump();
  const auto text = verdicts_of({line, failed("family/2")});
  const auto values = text.find("stick radius, shakedown"), verdict = text.find("1 of   2 agree");
  EXPECT_LT(values, verdict) << text;
  EXPECT_NE(verdict, std::string::npos) << text;
  EXPECT_NE(text.find("finite elements"), std::string::npos) << text;
}

TEST(Verdicts, NameEveryCaseWhoseNumericsFailed) {
  const auto text = verdicts_of({failed("one/a"), line_with("one/b", 1e-4, Outcome::agree)});
  expect_parts(text, {"FAILED       one/a: the pump is broken\n", "FAILED       one  ", "  1 of   2 agree, 1 failed"});
  EXPECT_EQ(text.find("DISAGREE"), std::string::npos) << "a failure is no disagreement: " << text;
}

// A sweep has a row a value, several cases that are none have not.
TEST(Verdicts, OfASweepHaveARowForEachValue) {
  std::vector<BatchLine> lines;
  for (const double value : {30, 90}) {
    auto json = stored_result();
    json["scene"]["sweep"]["value"] = value;
    lines.push_back(line_with("family/" + std::to_string(value), 1e-4, Outcome::agree));
    lines.back().json = json.dump();
  }
  expect_parts(verdicts_of(lines), {"Motion / Phase  ", "\n30 deg  ", "\n90 deg  "});
  for (auto& line : lines) {
    auto json = stored_result("single");
    line.json = json.dump();
  }
  EXPECT_EQ(verdicts_of(lines).find("Motion / Phase"), std::string::npos);
}

}  // namespace
}  // namespace fretval
