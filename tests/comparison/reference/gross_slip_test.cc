#include "comparison/reference/gross_slip.h"

#include <gtest/gtest.h>

#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

/// 1.5 ± 0.3 N, 1.3 N, mu 0.8.
MdrCase case_of_forces(const std::string& phase) {
  auto text = replace(replace(elastic_case(), "Indentation = 1e-4", "Normal force = 1.5"), "Normal amplitude = 2e-5",
                      "Normal force amplitude = 0.3");
  text = replace(text, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 1.3");
  text = replace(replace(text, "Phase = 60", "Phase = " + phase), "Coefficient = 0.5", "Coefficient = 0.8");
  return mdr_case(read_case(text));
}

// |1.3 e^{i 45°} + 0.24| = 1.4795 N of 1.2 N.
TEST(GrossSlip, BeginsWhereTheForcesBalance) {
  EXPECT_NEAR(steady_sliding_share(case_of_forces("45")).value(), 0.8111, 1e-4);
  EXPECT_NEAR(steady_sliding_share(case_of_forces("135")).value(), 0.8111, 1e-4) << "half a cycle later it is the same";
  EXPECT_NEAR(steady_sliding_share(case_of_forces("0")).value(), 1.2 / 1.54, 1e-12);
  EXPECT_NEAR(steady_sliding_share(case_of_forces("90")).value(), 1.2 / std::hypot(1.3, 0.24), 1e-12);
  EXPECT_NEAR(steady_sliding_share(case_of_forces("free")).value(), 1.2 / 1.54, 1e-12) << "the worst phase comes";
}

// Whatever the instant: the largest demand over a period is what friction carries on average.
TEST(GrossSlip, LeavesNoInstantAboveFriction) {
  const double share = steady_sliding_share(case_of_forces("45")).value(), phase = std::acos(-1.0) / 4;
  double largest = 0;
  for (double t = 0; t < 2 * std::acos(-1.0); t += 1e-3)
    largest =
        std::max(largest, std::abs(share * 1.3 * std::cos(t + phase)) / (0.8 * (1.5 + share * 0.3 * std::cos(t))));
  EXPECT_NEAR(largest, 1, 1e-6);
}

TEST(GrossSlip, IsNoAlgebraOfDisplacements) {
  EXPECT_FALSE(steady_sliding_share(mdr_case(read_case(elastic_case()))));
}

}  // namespace
}  // namespace fretval
