#include "comparison/simulation/fem_case/resolution_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace fretval {
namespace {

// Numbers that differ, so that none can stand in the place of another.
TEST(ResolutionJson, HasEveryNumberUnderItsName) {
  const auto json = resolution_json({24, 3, 0.5, 12, 36, 8, 1e-5});
  const nlohmann::ordered_json wanted{{"elements_per_radius", 24}, {"degree", 3},           {"growth", 0.5},
                                      {"far_radius", 12.},         {"steps_per_cycle", 36}, {"ramp_cycles", 8},
                                      {"periodicity", 1e-5}};
  EXPECT_EQ(json, wanted);
}

TEST(ResolutionJson, HasAFocusIfThereIsOne) {
  Resolution focused{24, 3, 0.5, 12, 36, 8, 1e-5};
  focused.focus = Focus{0.25, 0.5, 0.01};
  const auto json = resolution_json(focused);
  EXPECT_EQ(json.size(), 8U);
  EXPECT_EQ(json["focus"], (nlohmann::ordered_json{{"inner", 0.25}, {"outer", 0.5}, {"ring", 0.01}}));
}

}  // namespace
}  // namespace fretval
