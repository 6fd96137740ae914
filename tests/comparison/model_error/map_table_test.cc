#include "comparison/model_error/map_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "tests/comparison/model_error/made_up_map.h"

namespace fretval::map_table_test {
namespace {

TEST(MapTable, ComesBackFromItsText) {
  const auto points = made_up_map(1e-3), again = points_of_csv(csv_of(points));
  ASSERT_EQ(again.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(again[i].map, points[i].map);
    EXPECT_EQ(again[i].coupled, points[i].coupled);
    EXPECT_NEAR(*again[i].at.shakedown, *points[i].at.shakedown, 1e-6);
    EXPECT_FALSE(again[i].at.first_slip);
    ASSERT_EQ(again[i].changes.size(), 1U);
    const double value = points[i].changes.begin()->second.value;
    EXPECT_NEAR(again[i].changes.begin()->second.value, value, 5e-4 * std::abs(value));  // four digits
    EXPECT_NEAR(again[i].changes.begin()->second.bar, 1e-3, 1e-9);
  }
  EXPECT_EQ(csv_of(again), csv_of(points));
}

// Of MDR over the body and of MDR over a half-space.
TEST(MapTable, KeepsTheCoordinatesOfBothModels) {
  MapPoint point{"layer", {}, "cone", 0.25, true, false, {}};
  point.at.first_slip = 0.125;
  point.at.shakedown = 0.375;
  point.at.poisson_ratio = 0.4375;
  point.at.radius_over_thickness = 0.75;
  point.own = point.at;
  point.own.first_slip = 0.25;
  point.own.shakedown = 0.625;
  point.own.radius_over_thickness = 0.875;
  const auto again = points_of_csv(csv_of({point})).at(0);
  for (const auto& [one, same] : {std::pair{again.at, point.at}, {again.own, point.own}}) {
    EXPECT_EQ(one.first_slip, same.first_slip);
    EXPECT_EQ(one.shakedown, same.shakedown);
    EXPECT_EQ(one.poisson_ratio, same.poisson_ratio);
    EXPECT_EQ(one.radius_over_thickness, same.radius_over_thickness);
  }
  EXPECT_FALSE(again.memory);
}

TEST(MapPoint, IsOfTheSameSceneWhateverIsKnownOfIt) {
  const auto points = made_up_map();
  auto known = points.front();
  known.changes.clear();
  EXPECT_TRUE(is_same_scene(known, points.front()));
  EXPECT_FALSE(is_same_scene(points.back(), points.front()));
  known.friction_coefficient += 0.1;
  EXPECT_FALSE(is_same_scene(known, points.front()));
}

TEST(MapTable, TellsWhatIsWrong) {
  const auto text = csv_of(made_up_map());
  EXPECT_THROW(points_of_csv("map,scene\n"), InputError);
  EXPECT_THROW(points_of_csv(text + "phase,parabola\n"), InputError);
  auto damaged = text;
  damaged.replace(damaged.rfind("0.5,"), 3, "0.x");
  EXPECT_THROW(points_of_csv(damaged), InputError);
}

TEST(MapPoint, HasMdrOverAHalfSpaceAgainstTheTruth) {
  MapPoint point;
  point.changes[Quantity::normal_force_max] = {0.25, 0.05};
  EXPECT_FALSE(point.own_off_by(Quantity::normal_force_max));
  point.own_over_body[Quantity::normal_force_max] = 0.5;
  EXPECT_NEAR(point.own_off_by(Quantity::normal_force_max)->value, 0.5 / 1.25 - 1, 1e-15);
  EXPECT_NEAR(point.own_off_by(Quantity::normal_force_max)->bar, 0.5 / 1.25 * 0.05 / 1.25, 1e-15);
}

TEST(CommittedMap, HasAllMaps) {
  std::set<std::string> maps;
  for (const auto& point : map_points()) maps.insert(point.map);
  for (const auto kind : all_maps) EXPECT_EQ(maps.count(name_of(kind)), 1U) << name_of(kind);
  EXPECT_EQ(maps.count("elsewhere"), 1U);
}

}  // namespace
}  // namespace fretval::map_table_test
