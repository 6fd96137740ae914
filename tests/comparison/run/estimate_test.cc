#include "comparison/run/estimate.h"

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

// 1.3 N at 45 degrees to 1.5 +- 0.3 N slide (81.1 % of them would): one computation, which is not refined.
TEST(Estimate, OfSlidingIsThatOfOneComputation) {
  auto scene = read_case();
  scene.friction_coefficient = 0.8;
  scene.motion.normal_force = Case::NormalForce{1.5, 0.3};
  scene.motion.phase = 45;
  scene.motion.tangential_force = 1.3;
  const auto sliding = prepare({scene}).front();
  EXPECT_TRUE(slides(sliding));
  EXPECT_DOUBLE_EQ(estimated_seconds(sliding, Proof::tolerance), estimated_seconds(sliding, Proof::none));
  scene.motion.tangential_force = 0.6;
  EXPECT_FALSE(slides(prepare({scene}).front()));
  EXPECT_FALSE(slides(prepared_case()));
}

TEST(Estimate, OfManyIsSharedByTheCores) {
  std::vector<PreparedCase> cases{prepared_case(),
                                  prepared_case(valid_case + "subsection Wear\n  set Coefficient = 1e-12\nend\n")};
  cases[1].fem.body.far_radius *= 2;  // another body
  cases[0].input.name = "unworn";
  cases[1].input.name = "worn";
  const auto seconds = estimated_seconds(cases, Proof::bars, 2);
  ASSERT_EQ(seconds.size(), 2U);
  EXPECT_DOUBLE_EQ(seconds.at("unworn"), estimated_seconds(cases[0], Proof::bars) / 2);
  EXPECT_DOUBLE_EQ(seconds.at("worn"), estimated_seconds(cases[1], Proof::bars) / 2);
}

TEST(Estimate, BeginsWithTheLongestCasesAndLeavesEqualOnesTogether) {
  std::vector<PreparedCase> cases(4, prepared_case());
  for (std::size_t i = 0; i < cases.size(); ++i) cases[i].input.name = std::to_string(i);
  cases[0].fem.resolution.steps_per_cycle /= 2;
  cases[2].fem.resolution.steps_per_cycle *= 8;
  EXPECT_EQ(longest_first(cases, Proof::none), (std::vector<std::size_t>{2, 1, 3, 0}));
}

// A body is made once for all of them; their histories are their own.
TEST(Estimate, OfManyCountsASharedBodyOnce) {
  std::vector<PreparedCase> cases(4, prepared_case());
  for (std::size_t i = 0; i < cases.size(); ++i) cases[i].input.name = std::to_string(i);
  double sum = 0;
  for (const auto& [name, seconds] : estimated_seconds(cases, Proof::bars, 1)) sum += seconds;
  const double alone = estimated_seconds(cases[0], Proof::bars), shared = estimated_seconds(cases[0], Proof::bars, 4);
  EXPECT_LT(shared, alone);
  EXPECT_NEAR(sum, 4 * shared, 1e-9);
  const double histories = estimated_seconds(cases[0], Proof::bars, 1000000000);
  EXPECT_NEAR(sum, 4 * histories + (alone - histories), 1e-6 * sum);
}

// Steps under a force are solved for more than once.
TEST(Estimate, IsLongerUnderForces) {
  const auto forces = replace(replace(valid_case, "Indentation = 1e-4", "Normal force = 0.5"),
                              "Normal amplitude = 2e-5", "Normal force amplitude = 0.1");
  EXPECT_GT(estimated_seconds(prepared_case(forces), Proof::bars),
            1.5 * estimated_seconds(prepared_case(), Proof::bars));
}

}  // namespace
}  // namespace fretval::estimate_test
