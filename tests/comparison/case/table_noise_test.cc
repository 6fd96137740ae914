#include "comparison/case/table_noise.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::table_noise_test {
namespace {

/// Of a parabola of 10 mm whose heights scatter, in um, with a groove from one radius to another, in mm.
std::optional<double> noise_of(double scatter, double groove_from = 9, double groove_to = 9) {
  const ScratchFolder folder;
  std::mt19937 engine(5);
  std::normal_distribution<double> noise(0, 1);
  std::string rows = "r,f\nmm,um\n";
  for (int i = 0; i < 400; ++i) {
    const double r = 0.005 * i, deeper = r > groove_from && r < groove_to ? 20 : 0;
    rows += fmt::format("{:.4f},{:.6f}\n", r, 50 * r * r + deeper + (i > 0 ? scatter * noise(engine) : 0));
  }
  Case::Indenter indenter;
  indenter.shape = Case::Shape::table;
  indenter.table = folder.write("scan.csv", rows).string();
  return noise_behind_falls(indenter);
}

TEST(TableNoise, ExplainsWhyTheImageOfARoughTableFalls) {
  for (const double scatter : {0.2, 2.0}) {
    const auto found = noise_of(scatter);
    ASSERT_TRUE(found) << scatter;
    EXPECT_NEAR(*found, scatter * 1e-6, 0.3 * scatter * 1e-6);
  }
}

TEST(TableNoise, IsNoneOfASmoothTableOrOfDamage) {
  EXPECT_FALSE(noise_of(0));
  EXPECT_FALSE(noise_of(0, 0.5, 0.7));
  EXPECT_FALSE(noise_behind_falls({}));
}

TEST(TableNoise, IsSaidWithWhatToSet) {
  expect_parts(noise_text(2e-7), {"looks like noise of 0.2 um: set Indenter / Table noise = 0.2 um"});
  expect_parts(noise_text(3e-9), {"Table noise = 3 nm"});
}

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

// Off by 1e-7 m of a range of 4e-5 m: more than a thousandth of it, less than a hundredth.
TEST(NoisyStart, IsMeasuredByTheToleranceOfTheRange) {
  EXPECT_EQ(noisy_start(path_with(1e-7, 0), 1e-3).size(), 1U);
  EXPECT_EQ(noisy_start(path_with(1e-7, 0), 0).size(), 1U) << "a thousandth where no tolerance is set";
  EXPECT_TRUE(noisy_start(path_with(1e-7, 0), 1e-2).empty());
}

TEST(NoisyStart, IsNothingOfAForceOrOfAPassFromTheTouch) {
  auto by_force = path_with(5e-6, 0), from_touch = by_force;
  by_force.normal_force = true;
  from_touch.from_touch = true;
  EXPECT_TRUE(noisy_start(by_force, 1e-3).empty());
  EXPECT_TRUE(noisy_start(from_touch, 1e-3).empty());
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
  EXPECT_TRUE(noisy_start({{{0, 1, 2}, {1e-4, 2e-4, 1e-4}, {0, 1e-5, 0}}, "rows.csv"}, 1e-3).empty());
}

}  // namespace
}  // namespace fretval::table_noise_test
