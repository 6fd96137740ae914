#include "comparison/model_error/level_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/comparison/model_error/made_up_map.h"

namespace fretval::level_lines_test {
namespace {

TEST(LevelLines, AreWhereTheMapHasTheirLevel) {
  const auto lines =
      map_lines(made_up_map(), MapKind::phase, Quantity::stick_radius_shakedown, {0.02, 0.05, 0.5}).levels;
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

// Where MDR has the radius too small: 1/(1 + 0.1 (1 - c/a)) = 0.98.
TEST(LevelLines, AreOfBothSigns) {
  auto points = made_up_map();
  for (auto& point : points) point.changes.begin()->second.value *= -1;
  const auto line = map_lines(points, MapKind::phase, Quantity::stick_radius_shakedown, {0.02}).levels.front();
  ASSERT_FALSE(line.x.empty());
  for (const double x : line.x) EXPECT_TRUE(std::isnan(x) || std::abs(x - (1 - 0.2 / 0.98)) < 2e-4) << x;
}

// A mirror turns a motion by 180 degrees.
TEST(Hatching, OfAPhaseOfZeroIsThatOf180Too) {
  auto points = made_up_map();
  constexpr auto radius = Quantity::stick_radius_shakedown;
  for (auto& point : points)
    if (point.map == name_of(MapKind::phase) && point.own.phase == 0)
      point.changes.at(radius).bar = std::abs(point.changes.at(radius).value);
  const auto lines = map_lines(points, MapKind::phase, radius, {}).hatching;
  double least = 180, most = 0;
  for (const double y : lines.y) {
    if (std::isnan(y)) continue;
    least = std::min(least, y);
    most = std::max(most, y);
    EXPECT_TRUE(y < 60 || y > 120) << y;
  }
  EXPECT_EQ(least, 0);
  EXPECT_EQ(most, 180);
}

// The points of the made-up map are known exactly; with one bar that is wide the map is hatched around that point
// alone.
TEST(Hatching, IsNearPointsThatAreNotKnownToATenth) {
  auto points = made_up_map();
  constexpr auto radius = Quantity::stick_radius_shakedown;
  EXPECT_TRUE(map_lines(points, MapKind::phase, radius, {}).hatching.x.empty());
  auto& wide = points.at(13);  // c/a = 0.6, 60 degrees
  ASSERT_EQ(wide.map, name_of(MapKind::phase));
  wide.changes.at(radius).bar = std::abs(wide.changes.at(radius).value);
  const auto lines = map_lines(points, MapKind::phase, radius, {}).hatching;
  ASSERT_FALSE(lines.x.empty());
  double nearest = 1;
  for (std::size_t i = 0; i < lines.x.size(); ++i) {
    if (std::isnan(lines.x[i])) continue;
    const double across = (lines.x[i] - *wide.own.shakedown) / (most_mapped_ratio - least_mapped_ratio),
                 up = (lines.y[i] - wide.own.phase) / 180;
    nearest = std::min(nearest, std::hypot(across, up));
    EXPECT_LT(std::hypot(across, up), 0.4);
  }
  EXPECT_LT(nearest, 0.05);
  const double of_line = 2 * std::abs(wide.own_off_by(radius)->value);
  wide.changes.at(radius).bar = 0.15 * std::abs(wide.changes.at(radius).value);
  EXPECT_FALSE(map_lines(points, MapKind::phase, radius, {of_line / 10}).hatching.x.empty());
  EXPECT_TRUE(map_lines(points, MapKind::phase, radius, {of_line}).hatching.x.empty());
  EXPECT_FALSE(map_lines(points, MapKind::phase, radius, {of_line, of_line / 10}).hatching.x.empty())
      << "the lowest line decides";
}

// Where MDR has the radius too small, a bar of a twentieth of that is no wide one either.
TEST(Hatching, OfErrorsOfEitherSignIsNearWideBarsAlone) {
  for (const double sign : {1, -1}) {
    auto points = made_up_map();
    for (auto& point : points) {
      auto& change = point.changes.begin()->second;
      change = {sign * change.value, 0.05 * std::abs(change.value)};
    }
    EXPECT_TRUE(map_lines(points, MapKind::phase, Quantity::stick_radius_shakedown, {}).hatching.x.empty()) << sign;
  }
}

}  // namespace
}  // namespace fretval::level_lines_test
