#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "comparison/verification/trade/trade.h"
#include "tests/comparison/read_case.h"

namespace fretval::trade_levels_test {
namespace {

/// Rings alone, and a body with every degree of freedom.
TEST(TradeLevelsSlow, ErrorsFallWithRingsAndTheFullModelIsSlower) {
  const auto prepared = prepared_case();
  const auto plan = trade_plan(prepared.fem, {{8, 12, 16}, {2}, {2}, {0.3}, {12}, {48}, {8}, {1e-2}});
  std::map<std::string, std::vector<TradeLevel>> levels;
  std::map<double, double> errors;  // over rings
  for (const auto& level : computed_levels(prepared, plan)) {
    EXPECT_EQ(level.failure, "");
    EXPECT_GT(level.seconds, 0);
    levels[level.kind].push_back(level);
    if (level.axes.count("rings") > 0) errors[level.axes.at("rings")] = level.error();
  }
  EXPECT_LT(errors.at(12), errors.at(8));
  EXPECT_LT(errors.at(16), errors.at(12));
  EXPECT_LT(errors.at(8), 1e-2);
  // 2.6 times between 8 and 16 rings, 3.5e-4 to 1.3e-4 with elements of degree 2.
  EXPECT_LT(errors.at(16), errors.at(8) / 2);
  ASSERT_EQ(levels["condensed"].size(), plan.settings.size());
  EXPECT_EQ(levels["condensed"].front().errors.size(), 4U);
  ASSERT_EQ(levels["all dofs"].size(), 1U);
  const auto& full = levels["all dofs"].front();
  for (const auto& level : levels["condensed"])
    if (level.setting == full.setting) {
      EXPECT_GT(full.seconds, level.seconds);
    }
  ASSERT_EQ(levels["springs"].size(), 4U);
  EXPECT_LT(levels["springs"].back().errors.at(Quantity::stick_radius_shakedown), 1e-3);
  EXPECT_EQ(levels["closed form"].at(0).error(), 0);
}

TEST(TradePlan, VariesOneAxisAtATimeAndKeepsTheChoicesOfTheTool) {
  const auto prepared = prepared_case();
  const auto plan = trade_plan(prepared.fem);
  std::map<std::string, int> n;
  for (const auto& [resolution, axes] : plan.settings)
    for (const auto& [axis, value] : axes) ++n[axis];
  EXPECT_EQ(n,
            (std::map<std::string, int>{{"rings", 9}, {"order", 3}, {"grading", 3}, {"far radius", 4}, {"steps", 5}}));
  for (const double tolerance : {1e-2, 1e-3, 1e-4})
    EXPECT_EQ(plan.settings.count(chosen_resolution(tolerance, prepared.fem)), 1U) << tolerance;
  for (const auto& [resolution, axes] : plan.settings) {
    if (axes.count("rings") == 0) continue;
    EXPECT_EQ(resolution.elements_per_radius, axes.at("rings"));
    Resolution r = resolution;
    r.elements_per_radius = plan.reference.elements_per_radius;
    EXPECT_EQ(r, plan.reference);
  }
}

// Fine settings begin and end as finer tolerances ask for, on a far boundary that is further away.
TEST(TradePlan, GoesWithRingsAndStepsInAllElse) {
  const auto fem = prepared_case().fem;
  const auto plan = trade_plan(fem, {{16, 32, 48, 128}, {3}, {3}, {0.3}, {12}, {48, 96}, {16}, {1e-2}});
  EXPECT_EQ(plan.reference.elements_per_radius, 64U) << "at most";
  EXPECT_EQ(plan.reference.steps_per_cycle, 96);
  EXPECT_EQ(plan.reference.far_radius, 25);
  EXPECT_EQ(plan.reference.n_creep_cycles, resolution_for(1e-3).n_creep_cycles);
  ASSERT_EQ(plan.full.size(), 1U);
  EXPECT_EQ(plan.full[0].steps_per_cycle, 48) << "the fewest";
  EXPECT_EQ(plan.full[0].far_radius, 12);
  EXPECT_EQ(plan.full[0].n_creep_cycles, resolution_for(1e-2).n_creep_cycles);
  int n_of_32 = 0;
  for (const auto& [resolution, axes] : plan.settings)
    if (axes.empty() && resolution.elements_per_radius == 32) {
      EXPECT_EQ(resolution.far_radius, 12);
      ++n_of_32;
    }
  EXPECT_EQ(n_of_32, 2);
}

// Histories of an unlocked phase are long.
TEST(TradePlan, OfALongHistoryIsSmaller) {
  auto scene = prepared_case().fem;
  const auto finest = [](const TradePlan& plan) {
    unsigned rings = 0;
    int steps = 0;
    for (const auto& [resolution, axes] : plan.settings) {
      rings = std::max(rings, resolution.elements_per_radius);
      steps = std::max(steps, resolution.steps_per_cycle);
    }
    return std::make_pair(rings, steps);
  };
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(128U, 192));
  scene.motion.locked = false;
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(48U, 96));
}

}  // namespace
}  // namespace fretval::trade_levels_test
