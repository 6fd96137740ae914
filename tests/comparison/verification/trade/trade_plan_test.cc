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
  for (const auto& [resolution, sweeps] : plan.settings)
    for (const auto& sweep : sweeps) ++n[sweep];
  EXPECT_EQ(n["rings"], 9);
  EXPECT_EQ(n["element order"], 3);
  EXPECT_EQ(n["grading"], 3);
  EXPECT_EQ(n["far field"], 4);
  EXPECT_EQ(n["time step"], 5);
  EXPECT_EQ(n["joint"], 90);
  EXPECT_EQ(n["chosen"], 3);
  for (const auto& [resolution, sweeps] : plan.settings) {
    if (sweeps.count("rings") == 0) continue;
    Resolution r = resolution;
    r.elements_per_radius = plan.reference.elements_per_radius;
    EXPECT_FALSE(r < plan.reference || plan.reference < r);
  }
}

TEST(TradeAxes, ReadTheEntryThatTheyVary) {
  const Resolution r{8, 3, 0.25, 12, 24, 1, 1e-6};
  std::map<std::string, double> values;
  for (const auto& axis : trade_axes()) values[axis.name] = axis.value(r);
  EXPECT_EQ(values, (std::map<std::string, double>{
                        {"rings", 8}, {"element order", 3}, {"grading", 0.25}, {"far field", 12}, {"time step", 24}}));
}

// Histories of an unlocked phase are long.
TEST(TradePlan, OfALongHistoryIsSmaller) {
  auto scene = prepared_case().fem;
  const auto finest = [](const TradePlan& plan) {
    unsigned rings = 0;
    int steps = 0;
    for (const auto& [resolution, sweeps] : plan.settings) {
      if (sweeps.count("chosen") > 0) continue;
      rings = std::max(rings, resolution.elements_per_radius);
      steps = std::max(steps, resolution.steps_per_cycle);
    }
    return std::make_pair(rings, steps);
  };
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(128U, 192));
  scene.motion.phase.reset();
  EXPECT_EQ(finest(trade_plan(scene)), std::make_pair(48U, 96));
}

}  // namespace
}  // namespace fretval
