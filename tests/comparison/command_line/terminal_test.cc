#include "comparison/command_line/terminal.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/comparison/stored_result.h"

namespace fretval {
namespace {

BatchLine line_with(const std::string& name, std::optional<double> difference, Verdict verdict) {
  const Comparison comparison{{Quantity::stick_radius_shakedown, {difference, 1e-3, verdict}}};
  return {name, verdict == Verdict::pass, "", largest_use(comparison, name)};
}

BatchLine failed(const std::string& name) {
  return {name, false, "the pump is broken", {}};
}

std::string verdicts_of(const std::vector<BatchLine>& lines) {
  testing::internal::CaptureStdout();
  print_verdicts(lines);
  return testing::internal::GetCapturedStdout();
}

TEST(Outcome, IsALineOfTheLog) {
  auto good = line_with("family/1", 1e-4, Verdict::pass);
  good.seconds = 1.23;
  EXPECT_EQ(outcome_text(good), "family/1: agrees in 1.2 s");
  EXPECT_EQ(outcome_text(line_with("family/2", 2e-3, Verdict::fail)), "family/2: DISAGREES in 0.0 s");
  auto open = line_with("family/2", 2e-3, Verdict::inconclusive);
  open.open = true;
  EXPECT_EQ(outcome_text(open), "family/2: open, its error bars are wider than the tolerance, in 0.0 s");
  EXPECT_EQ(outcome_text(failed("family/3")), "family/3: FAILED: the pump is broken");
}

TEST(Verdicts, NameTheLargestUseOfAToleranceOfEachFile) {
  const auto text = verdicts_of({line_with("one/a", 2e-4, Verdict::pass), line_with("one/b", -5e-4, Verdict::pass),
                                 line_with("two/a", 1e-5, Verdict::pass)});
  EXPECT_NE(
      text.find("2 of   2 agree; largest use of a tolerance: stick radius, shakedown in one/b: -5.0e-04 of 1.0e-03"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("stick radius, shakedown in two/a: 1.0e-05"), std::string::npos) << text;
  EXPECT_EQ(text.find("DISAGREE"), std::string::npos) << text;
}

// With wide bars nobody can say that they disagree.
TEST(Verdicts, OfWideBarsAreOpen) {
  auto open = line_with("one/a", 2e-4, Verdict::inconclusive);
  open.open = true;
  const auto good = line_with("one/b", 2e-4, Verdict::pass), bad = line_with("one/c", 2e-3, Verdict::fail);
  EXPECT_NE(verdicts_of({open, good}).find("open     one "), std::string::npos) << verdicts_of({open, good});
  EXPECT_NE(verdicts_of({open, bad}).find("DISAGREE one "), std::string::npos) << verdicts_of({open, bad});
}

TEST(Verdicts, ComeAfterTheValues) {
  auto line = line_with("family/1", 1e-4, Verdict::pass);
  line.json = stored_result().dump();
  const auto text = verdicts_of({line, failed("family/2")});
  const auto values = text.find("stick radius, shakedown"), verdict = text.find("1 of   2 agree");
  EXPECT_LT(values, verdict) << text;
  EXPECT_NE(verdict, std::string::npos) << text;
  EXPECT_NE(text.find("finite elements"), std::string::npos) << text;
}

TEST(Verdicts, NameEveryCaseWhoseNumericsFailed) {
  const auto text = verdicts_of({failed("one/a"), line_with("one/b", 1e-4, Verdict::pass)});
  EXPECT_NE(text.find("FAILED   one/a: the pump is broken\n"), std::string::npos) << text;
  EXPECT_NE(text.find("DISAGREE one"), std::string::npos) << text;
}

}  // namespace
}  // namespace fretval
