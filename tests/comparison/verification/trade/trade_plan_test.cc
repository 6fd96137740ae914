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
  std::map<Sweep, int> n;
  for (const auto& setting : plan.settings)
    for (const Sweep sweep : setting.sweeps) ++n[sweep];
  EXPECT_EQ(n[Sweep::rings], 9);
  EXPECT_EQ(n[Sweep::element_order], 3);
  EXPECT_EQ(n[Sweep::grading], 3);
  EXPECT_EQ(n[Sweep::far_field], 4);
  EXPECT_EQ(n[Sweep::time_step], 5);
  EXPECT_EQ(n[Sweep::joint], 90);
  EXPECT_EQ(n[Sweep::chosen], 3);
  for (const auto& setting : plan.settings) {
    if (setting.sweeps.count(Sweep::rings) == 0) continue;
    Resolution r = setting.resolution;
    r.elements_per_radius = plan.reference.elements_per_radius;
    EXPECT_FALSE(r < plan.reference || plan.reference < r);
  }
}

// Histories of an unlocked phase are long, those of a dashpot or a worn edge slow.
TEST(TradePlan, OfALongHistoryIsSmaller) {
  auto scene = prepared_case().fem;
  const auto finest = [](const TradePlan& plan) {
    unsigned rings = 0;
    int steps = 0;
    for (const auto& setting : plan.settings) {
      if (setting.sweeps.count(Sweep::chosen) > 0) continue;
      rings = std::max(rings, setting.resolution.elements_per_radius);
      steps = std::max(steps, setting.resolution.steps_per_cycle);
    }
    return std::make_pair(rings, steps);
  };
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(128U, 192));
  EXPECT_EQ(trade_plan(scene).n_repetitions, 2);
  auto dashpot = scene;
  dashpot.relaxation.viscosity = 0.1;
  EXPECT_EQ(finest(trade_plan(dashpot)), std::make_pair(128U, 192));
  EXPECT_EQ(trade_plan(dashpot).n_repetitions, 1);
  scene.motion.phase.reset();
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(48U, 96));
  EXPECT_EQ(trade_plan(scene).n_repetitions, 1);
}

}  // namespace
}  // namespace fretval
