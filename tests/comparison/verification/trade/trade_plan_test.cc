#include "comparison/verification/trade/trade_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

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
}  // namespace fretval
