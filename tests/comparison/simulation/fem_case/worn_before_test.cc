#include "comparison/simulation/fem_case/worn_before.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::worn_before_test {
namespace {

const Units units{1e-3, 1e-4, 1e6, 6.0};  // m, m, Pa, rad/s

double parabola(double r) {
  return r * r / 2;
}

TEST(WornBefore, OfHeightsIsLinearInTheDepthAndBeginsHalfway) {
  const ScratchFolder folder;
  // Unworn to 0.6 mm, 8 um deep at 0.8 mm, 4 um at 1 mm.
  const auto table = folder.write("worn.csv", "r [mm],f [um]\n0,0\n0.6,18\n0.8,40\n1,54\n").string();
  const auto before = worn_by_heights(table, units, parabola, 1e-3);
  EXPECT_EQ(before.depth(0.3), 0);
  EXPECT_EQ(before.depth(0.69), 0);
  EXPECT_NEAR(before.depth(0.71), 0.08, 1e-12);
  EXPECT_NEAR(before.depth(0.9), 0.06, 1e-12);
  EXPECT_EQ(before.depth(1.1), 0) << "beyond the rows";
  ASSERT_EQ(before.kinks.size(), 6u);
  EXPECT_NEAR(before.kinks[3], 0.7, 1e-12);
}

TEST(WornBefore, OfHeightsIsNoGrowth) {
  const ScratchFolder folder;
  const auto table = folder.write("worn.csv", "r [mm],f [um]\n0,0\n1,49\n").string();
  expect_parts(refusal([&] { worn_by_heights(table, units, parabola, 1e-3); }),
               {"worn.csv: the height 4.9e-05 m at r = 0.001 m is 1e-06 m below"});
}

TEST(WornBefore, OfRingsIsThatOfEachRing) {
  const ScratchFolder folder;
  const auto table = folder.write("rings.csv", "r outer [mm],worn depth [um]\n0.5,0\n0.75,20\n1,5\n").string();
  const auto before = worn_by_rings(table, units);
  EXPECT_EQ(before.depth(0.49), 0);
  EXPECT_NEAR(before.depth(0.51), 0.2, 1e-15);
  EXPECT_NEAR(before.depth(0.99), 0.05, 1e-15);
  EXPECT_EQ(before.depth(1.01), 0);
  EXPECT_EQ(before.kinks, (std::vector<double>{0.5, 0.75, 1}));
}

TEST(WornBefore, OfRingsTheyFollowEachOther) {
  const ScratchFolder folder;
  const auto table = [&](const std::string& rows) {
    return folder.write("rings.csv", "r outer [m],worn depth [m]\n" + rows).string();
  };
  expect_parts(refusal([&] { worn_by_rings(table("1e-3,0\n1e-3,1e-6\n"), units); }),
               {"rings.csv, line 3: the outer radius 0.001", "greater"});
  expect_parts(refusal([&] { worn_by_rings(table("1e-3,-1e-6\n"), units); }),
               {"rings.csv, line 2: the worn depth -1e-06", "not be negative"});
  expect_parts(refusal([&] { worn_by_rings(table("one,two\n"), units); }), {"rings.csv"});
}

}  // namespace
}  // namespace fretval::worn_before_test
