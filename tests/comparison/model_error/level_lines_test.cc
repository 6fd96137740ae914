#include "comparison/model_error/level_lines.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/model_error/made_up_map.h"

namespace fretval::level_lines_test {
namespace {

TEST(LevelLines, AreWhereTheMapHasTheirLevel) {
  const auto lines = level_lines(made_up_map(), MapKind::phase, Quantity::stick_radius_shakedown, {0.02, 0.05, 0.5});
  ASSERT_EQ(lines.size(), 3U);
  for (const auto& [line, ratio] : {std::pair(lines[0], 1 - 0.2 / 1.02), std::pair(lines[1], 1 - 0.5 / 1.05)}) {
    ASSERT_FALSE(line.x.empty());
    double top = 0;
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      if (std::isnan(line.x[i])) continue;
      EXPECT_NEAR(line.x[i], ratio, 2e-4);
      top = std::max(top, line.y[i]);
    }
    EXPECT_EQ(top, 180);
  }
  EXPECT_TRUE(lines[2].x.empty());
}

}  // namespace
}  // namespace fretval::level_lines_test
