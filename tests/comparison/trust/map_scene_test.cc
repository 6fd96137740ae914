#include "comparison/trust/map_scene.h"

#include <gtest/gtest.h>

#include "comparison/model_error/coordinates.h"

namespace fretval::map_scene_test {
namespace {

TEST(CaseOfScene, LiesWhereTheSceneSays) {
  std::vector<MapScene> scenes{{0.2}, {0.95}, {0.58, 0}};
  scenes.push_back({0.5, 60, 0.3});
  scenes.push_back({0.6, 60, 0.5, 1.0});
  scenes.push_back({0.6, 60, 0.5, 0.5, false, true});
  MapScene cone{0.58, 75};
  cone.cone_angle = 5;
  scenes.push_back(cone);
  for (const auto& scene : scenes) {
    const auto input = case_of(scene);
    const auto at = coordinates_of(input);
    EXPECT_NEAR(at.shakedown.value(), scene.stick_ratio, 5e-3);
    EXPECT_NEAR(at.phase, scene.phase, 1e-12);
    EXPECT_NEAR(at.contact_radius, 1e-3, 2e-5);
    EXPECT_NEAR(at.radius_over_thickness, scene.radius_over_thickness, 2e-2);
    EXPECT_EQ(at.poisson_ratio, scene.poisson_ratio);
    EXPECT_EQ(input.motion.normal_force.has_value(), scene.by_normal_force);
  }
}

TEST(CaseOfScene, HasTheRatioOfAmplitudes) {
  MapScene scene{0.5};
  scene.amplitude_ratio = 1.5;
  const auto motion = case_of(scene).motion;
  EXPECT_NEAR(3 * 0.5 * motion.normal_amplitude / (2 * motion.tangential_amplitude), 1.5, 1e-12);
}

}  // namespace
}  // namespace fretval::map_scene_test
