#include "comparison/results/estimate.h"

#include <gtest/gtest.h>

#include "tests/comparison/read_case.h"

namespace fretval::estimate_test {
namespace {

TEST(Estimate, GrowsWithWhatIsAskedFor) {
  const auto coarse = resolution_for(1e-3), fine = resolution_for(1e-4);
  EXPECT_GT(estimated_seconds(fine, 1, 5), estimated_seconds(coarse, 1, 5));
  EXPECT_EQ(estimated_seconds(coarse, 1, 10), 2 * estimated_seconds(coarse, 1, 5));
  EXPECT_GT(estimated_seconds(coarse, 3, 5), estimated_seconds(coarse, 1, 5));
}

// 16 rings and 16 steps: less than the tolerance asks for.
TEST(Estimate, IsThatOfTheRingsAndStepsThatTheCaseFileFixes) {
  const auto coarse =
      read_case(replace(valid_case, "subsection Accuracy",
                        "subsection Accuracy\n  set Rings per radius = 16\n  set Steps per cycle = 16"));
  EXPECT_LT(estimated_seconds(prepare({coarse}).front(), Proof::bars),
            0.7 * estimated_seconds(prepare({read_case()}).front(), Proof::bars));
}

TEST(Estimate, OfACaseGrowsWithItsProofAndItsWear) {
  const auto prepared = prepare({read_case()}).front();
  const double none = estimated_seconds(prepared, Proof::none), bars = estimated_seconds(prepared, Proof::bars);
  EXPECT_GT(none, 0);
  EXPECT_GT(bars, none);
  EXPECT_GT(estimated_seconds(prepared, Proof::tolerance), bars);
  const auto worn = prepare({read_case(valid_case + "subsection Wear\n  set Coefficient = 1e-12\nend\n")}).front();
  EXPECT_GT(estimated_seconds(worn, Proof::bars), 2 * bars);
}

TEST(Estimate, OfManyIsSharedByTheCores) {
  std::vector<PreparedCase> cases{prepared_case(),
                                  prepared_case(valid_case + "subsection Wear\n  set Coefficient = 1e-12\nend\n")};
  cases[0].input.name = "unworn";
  cases[1].input.name = "worn";
  const auto seconds = estimated_seconds(cases, Proof::bars, 2);
  ASSERT_EQ(seconds.size(), 2U);
  EXPECT_DOUBLE_EQ(seconds.at("unworn"), estimated_seconds(cases[0], Proof::bars) / 2);
  EXPECT_DOUBLE_EQ(seconds.at("worn"), estimated_seconds(cases[1], Proof::bars) / 2);
}

}  // namespace
}  // namespace fretval::estimate_test
