#include "comparison/trust/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace fretval::map_test {
namespace {

TEST(PlannedPoints, AreOfAllMapsAndElsewhere) {
  std::set<std::string> maps;
  for (const auto& point : planned_points()) {
    maps.insert(point.map);
    EXPECT_EQ(point.title.find(','), std::string::npos) << point.title;
  }
  EXPECT_EQ(maps.size(), all_maps.size() + 1);
}

TEST(PointByMdr, HasBothOfItsModels) {
  MapScene scene{0.6};
  scene.radius_over_thickness = 1;
  const auto point = point_by_mdr({"layer", "", scene}, case_of(scene));
  EXPECT_NEAR(*point.at.shakedown, 0.6, 5e-3);
  EXPECT_NEAR(point.at.radius_over_thickness, 1, 1e-6);
  EXPECT_LT(point.own.radius_over_thickness, 1);
  EXPECT_LT(point.own_over_body.at(Quantity::normal_force_max), 0.8);
}

TEST(ComputedMap, KeepsThePointsThatAreKnown) {
  std::vector<PlannedPoint> planned;
  std::vector<MapPoint> known;
  for (const double phase : {90.0, 60.0}) {
    MapScene scene{0.7};
    scene.phase = phase;
    planned.push_back({"phase", "parabola", scene});
    known.push_back(point_by_mdr(planned.back(), case_of(scene)));
    known.back().changes[Quantity::friction_work] = {phase / 1000, 1e-3};
  }
  std::reverse(known.begin(), known.end());
  BodyStore bodies;
  const auto points = computed_map(planned, points_of_csv(csv_of(known)), bodies,
                                   [](const std::vector<MapPoint>&, std::size_t) { FAIL() << "nothing is missing"; });
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].changes.at(Quantity::friction_work).value, 0.09);
  EXPECT_EQ(points[1].changes.at(Quantity::friction_work).value, 0.06);
}

// At nu = 0 both tangential responses are equal: a direction of friction that turns changes nothing. Over an
// incompressible half-space it takes some of the stick radius away.
TEST(ComputedPoint, KnowsWhereTheDirectionOfFrictionMatters) {
  BodyStore bodies;
  MapScene scene{0.7};
  const auto incompressible = computed_point({"phase", "", scene}, bodies, 0.25);
  const auto& radius = incompressible.changes.at(Quantity::stick_radius_shakedown);
  EXPECT_LT(radius.value, -radius.bar);
  EXPECT_GT(radius.value, -0.05);
  scene.poisson_ratio = 0;
  const auto compressible = computed_point({"phase", "", scene}, bodies, 0.25);
  const auto& none = compressible.changes.at(Quantity::stick_radius_shakedown);
  EXPECT_NEAR(none.value, 0, 1e-6);
}

// Of 48 equal rings to the contact radius, the fewest of a bar would have two in a zone of 0.2 a: its bar would be as
// wide as the value.
TEST(ComputedPointSlow, ResolvesASmallStickZone) {
  BodyStore bodies;
  MapScene scene{0.2};
  scene.phase = 90;
  const auto& radius = computed_point({"phase", "", scene}, bodies, 0.5).changes.at(Quantity::stick_radius_shakedown);
  EXPECT_NEAR(radius.value, -0.07, 0.02);
  EXPECT_LT(radius.bar, 0.014);
}

// All slip takes place within 0.05 a of the edge, of two in 48 equal rings. The value is that of 192 equal rings and
// 144 steps, the mean over eight places of the edge in its ring; 96 and 48 rings have -0.02273 and -0.02236.
TEST(ComputedPointSlow, ResolvesAThinSlipAnnulus) {
  BodyStore bodies;
  MapScene scene{0.95};
  scene.phase = 0;
  const auto& work = computed_point({"phase", "", scene}, bodies, 0.5).changes.at(Quantity::friction_work);
  EXPECT_NEAR(work.value, -0.02276, work.bar);
  EXPECT_LT(work.bar, 0.007);
}

}  // namespace
}  // namespace fretval::map_test
