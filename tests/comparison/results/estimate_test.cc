#include "comparison/results/estimate.h"

#include <gtest/gtest.h>

#include "tests/comparison/read_case.h"

namespace fretval::estimate_test {
namespace {

TEST(Estimate, GrowsWithWhatIsAskedFor) {
  EXPECT_GT(estimated_seconds(1e-4, true, 1, 5), estimated_seconds(1e-3, true, 1, 5));
  EXPECT_EQ(estimated_seconds(1e-3, true, 1, 10), 2 * estimated_seconds(1e-3, true, 1, 5));
  EXPECT_GT(estimated_seconds(1e-3, true, 3, 5), estimated_seconds(1e-3, true, 1, 5));
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
  const auto prepared = prepare({read_case()}).front();
  const double one = estimated_seconds(prepared, Proof::bars);
  EXPECT_DOUBLE_EQ(estimated_seconds({prepared, prepared, prepared}, Proof::bars, 2), 1.5 * one);
}

}  // namespace
}  // namespace fretval::estimate_test
