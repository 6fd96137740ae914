#include "comparison/case/noisy_start.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/comparison/expect_parts.h"

namespace fretval::noisy_start_test {
namespace {

/// A pass of 200 rows whose first one is off in d, and all of which scatter, in m.
Case::Path path_with(double first, double scatter) {
  std::mt19937 engine(3);
  std::normal_distribution<double> noise(0, 1);
  Case::Path path;
  path.file = "rows.csv";
  for (int i = 0; i < 200; ++i) {
    const double t = 0.01 * i;
    path.time.push_back(t);
    path.normal.push_back(1e-4 + 2e-5 * std::sin(2 * t) + scatter * noise(engine) + (i == 0 ? first : 0));
    path.tangential.push_back(1.5e-5 * (1 - std::cos(3 * t)));
  }
  return path;
}

TEST(NoisyStart, IsSaidOfARowThatTheOthersDoNotLeadTo) {
  const auto warnings = noisy_start(path_with(5e-6, 0), 1e-3);
  ASSERT_EQ(warnings.size(), 1U);
  expect_parts(warnings[0], {"rows.csv: d = 0.000105 m in the first row is 5e-06 m off", "moves with it"});
  EXPECT_EQ(noisy_start(path_with(0, 3e-6), 1e-3).size(), 1U) << "all rows scatter, and so does the first";
}

TEST(NoisyStart, IsNothingOfASmoothPathOrOneThatRepeatsOrHasFewRows) {
  EXPECT_TRUE(noisy_start(path_with(0, 0), 1e-3).empty());
  EXPECT_TRUE(noisy_start(path_with(0, 1e-9), 1e-3).empty());
  auto path = path_with(5e-6, 0);
  path.repeats = true;
  EXPECT_TRUE(noisy_start(path, 1e-3).empty());
  auto reduced = path_with(5e-6, 0);
  reduced.reduction = Case::PathReduction{3000, 10};
  EXPECT_TRUE(noisy_start(reduced, 1e-3).empty()) << "rows that were left out stood between those that are kept";
  EXPECT_TRUE(noisy_start({"rows.csv", {0, 1, 2}, {1e-4, 2e-4, 1e-4}, {0, 1e-5, 0}}, 1e-3).empty());
}

}  // namespace
}  // namespace fretval::noisy_start_test
