#include "comparison/simulation/wear_run.h"

#include <gtest/gtest.h>

#include "tests/comparison/wearing_case.h"

namespace fretval::wear_run_test {
namespace {

// f = r^2/2 in units of the contact radius and the largest indentation, which is a^2/R.
TEST(WearRun, ReachesToThePlaneOfTheLargestIndentation) {
  const auto fem = wearing_case("  set Coefficient = 1e-12\n").fem;
  const double reach = widest_wear(fem, 1);
  EXPECT_NEAR(fem.profile(reach), 1, 5e-3);
  EXPECT_GE(fem.profile(reach), 1);
  EXPECT_GT(widest_wear(fem, 2), reach);
}

}  // namespace
}  // namespace fretval::wear_run_test
