#include "comparison/verification/suite.h"

#include <gtest/gtest.h>

#include "comparison/verification/suites.h"
#include "comparison/verification/written_case.h"
#include "tests/comparison/suite_rows.h"

namespace fretval {
namespace {

SuiteRow with_proof(SuiteRow row, Proof proof) {
  row.asked.proof = proof;
  return row;
}

TEST(SuiteRow, AgreesWithinToleranceAndBar) {
  EXPECT_EQ(verdict_of(row_of(1e-3, 2e-3)), RowVerdict::agrees);
  EXPECT_EQ(verdict_of(row_of(-1e-3, 2e-3)), RowVerdict::agrees);
  EXPECT_EQ(failure_of(row_of(1e-3, 2e-3)), "");
}

TEST(SuiteRow, IsInconclusiveWithAWideBarThatCovers) {
  EXPECT_EQ(verdict_of(row_of(1e-3, 2e-2)), RowVerdict::inconclusive);
  EXPECT_EQ(verdict_of(row_of(1.5e-2, 2e-2)), RowVerdict::inconclusive);
}

TEST(SuiteRow, FailsWithAWideBarWhereItHasToBeConclusive) {
  auto wide = row_of(1e-3, 2e-2), narrow = row_of(1e-3, 1e-2);
  wide.asked.must_be_conclusive = narrow.asked.must_be_conclusive = true;
  EXPECT_EQ(verdict_of(wide), RowVerdict::fails);
  EXPECT_EQ(failure_of(wide), "stick radius, shakedown: the bar 2.0e-02 is wider than the tolerance 1e-02");
  EXPECT_EQ(verdict_of(narrow), RowVerdict::agrees);
}

TEST(SuiteRow, FailsWithAnErrorAboveItsBar) {
  EXPECT_EQ(verdict_of(row_of(1e-3, 5e-4)), RowVerdict::fails);
  EXPECT_EQ(verdict_of(row_of(3e-2, 2e-2)), RowVerdict::fails);
  EXPECT_EQ(verdict_of(with_proof(row_of(3e-2, 2e-2), Proof::bars)), RowVerdict::fails);
  EXPECT_EQ(failure_of(row_of(3e-2, 2e-2)), "stick radius, shakedown: the error 3.0e-02 is above its bar 2.0e-02");
  EXPECT_EQ(verdict_of(row_of(1e-13, 0)), RowVerdict::agrees) << "roundoff";
  EXPECT_EQ(verdict_of(row_of(1e-11, 0)), RowVerdict::fails);
}

TEST(SuiteRow, WithoutABarIsHeldToItsTolerance) {
  EXPECT_EQ(verdict_of(with_proof(row_of(9e-3, {}), Proof::none)), RowVerdict::agrees);
  const auto off = with_proof(row_of(-1.1e-2, {}), Proof::none);
  EXPECT_EQ(failure_of(off), "stick radius, shakedown: the error -1.1e-02 is above its tolerance 1.0e-02");
}

TEST(SuiteRow, FailsWithoutFiniteNumbers) {
  for (const Proof proof : {Proof::none, Proof::bars, Proof::tolerance}) {
    EXPECT_EQ(verdict_of(with_proof(row_of(not_a_number, 1e-3), proof)), RowVerdict::fails);
    EXPECT_EQ(verdict_of(with_proof(row_of(not_a_number, {}), proof)), RowVerdict::fails);
    EXPECT_EQ(verdict_of(with_proof(row_of(not_a_number, infinity), proof)), RowVerdict::fails);
    EXPECT_EQ(verdict_of(with_proof(row_of(infinity, 1e-3), proof)), RowVerdict::fails);
    EXPECT_EQ(verdict_of(with_proof(row_of(infinity, infinity), proof)), RowVerdict::fails);
    EXPECT_EQ(verdict_of(with_proof(row_of(1e-3, not_a_number), proof)), RowVerdict::fails);
  }
}

TEST(SuiteRow, MayHaveAnInfiniteBarOnlyWhereNothingIsRefined) {
  EXPECT_EQ(verdict_of(row_of(1e-3, infinity)), RowVerdict::fails);
  EXPECT_EQ(verdict_of(with_proof(row_of(1e-3, infinity), Proof::bars)), RowVerdict::inconclusive);
}

TEST(SuiteRow, OneQuantityIsEnoughToFail) {
  auto row = row_of(1e-3, 2e-3);
  row.compared[Quantity::normal_force_max] = {1, 1.1, 1e-3, 1e-4, "rings"};
  EXPECT_EQ(verdict_of(row), RowVerdict::fails);
}

TEST(SuiteRow, AcceptsARefusalOnlyWhereItIsExpected) {
  EXPECT_EQ(verdict_of(refused_row("Motion / Phase", "case.prm: Motion / Phase = x: ...")), RowVerdict::refused);
  EXPECT_EQ(verdict_of(refused_row("", "case.prm: Motion / Phase = x: ...")), RowVerdict::fails);
  EXPECT_EQ(verdict_of(refused_row("Motion / Phase", "out of memory")), RowVerdict::fails);
  EXPECT_EQ(verdict_of(refused_row("Motion / Phase", "")), RowVerdict::fails);
  auto answered = row_of(1e-3, 2e-3);
  answered.asked.refusal = "Motion / Phase";
  EXPECT_EQ(verdict_of(answered), RowVerdict::fails);
}

TEST(SuiteRow, FailsWithoutAnyNumberOrWithAnotherException) {
  EXPECT_EQ(failure_of(SuiteRow{}), "nothing was compared");
  SuiteRow sliding;
  sliding.sliding = Outcome::agree;
  EXPECT_EQ(verdict_of(sliding), RowVerdict::agrees);
  sliding.sliding = Outcome::not_resolved;
  EXPECT_EQ(verdict_of(sliding), RowVerdict::inconclusive);
  sliding.sliding = Outcome::disagree;
  EXPECT_EQ(failure_of(sliding), "only one method finds gross slip, or not where it has to");
  auto row = row_of(1e-3, 2e-3);
  row.failure = "std::bad_alloc";
  EXPECT_EQ(verdict_of(row), RowVerdict::fails);
  EXPECT_EQ(failure_of(row), "std::bad_alloc");
}

TEST(SuiteRun, PassesIfNoRowFails) {
  EXPECT_TRUE(run_of({row_of(1e-3, 2e-3), row_of(1e-3, 2e-2), refused_row("a", "a b")}).passes());
  EXPECT_FALSE(run_of({row_of(1e-3, 2e-3), row_of(3e-3, 2e-3)}).passes());
  EXPECT_FALSE(run_of({}).passes());
}

/// A coarse case that agrees.
SuiteCase good_case() {
  SuiteCase one{"family", "good", case_text(elastic_base())};
  one.proof = Proof::bars;
  return one;
}

SuiteRow run_alone(const SuiteCase& one) {
  BodyStore bodies;
  return run_cases({one}, bodies).front();
}

TEST(SuiteCase, IsHeldAgainstMdr) {
  const auto row = run_alone(good_case());
  EXPECT_EQ(failure_of(row), "");
  ASSERT_EQ(row.compared.size(), 4U);
  for (const auto& [quantity, q] : row.compared) {
    EXPECT_GT(q.bar.value(), 0);
    EXPECT_NE(q.source, "");
    EXPECT_EQ(q.tolerance,
              quantity == Quantity::contact_radius_max || quantity == Quantity::normal_force_max ? 1e-3 : 1e-2);
  }
  EXPECT_GT(row.n_computations, 1);
  EXPECT_EQ(row.n_refinements, 0);
}

// Finite elements of another case than MDR's are not covered by their bars.
TEST(SuiteCaseGuard, FailsForAnotherCase) {
  auto one = good_case();
  one.change = [](PreparedCase& prepared) { prepared.fem.friction_coefficient *= 1.4; };
  const auto row = run_alone(one);
  EXPECT_NE(failure_of(row).find("is above its bar"), std::string::npos) << failure_of(row);
}

TEST(SuiteCaseGuard, FailsWithAnUnexpectedAnswerRefusalOrException) {
  auto answers = good_case(), refuses = good_case(), throws = good_case();
  answers.refusal = "Motion / Phase";
  refuses.text = case_text(with(elastic_base(), {{"Friction / Coefficient", "0"}}));
  throws.change = [](PreparedCase&) { throw std::logic_error("a mistake"); };
  EXPECT_EQ(failure_of(run_alone(answers)), "not refused; the message should say: Motion / Phase");
  EXPECT_NE(failure_of(run_alone(refuses)).find("refused: family: good: Friction / Coefficient = 0"),
            std::string::npos);
  EXPECT_EQ(failure_of(run_alone(throws)), "a mistake");
}

}  // namespace
}  // namespace fretval
