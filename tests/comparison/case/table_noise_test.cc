#include "comparison/case/table_noise.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fretval::table_noise_test
