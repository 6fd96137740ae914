#include "comparison/reference/plane_answer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/data/path_table.h"
#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/suite_case.h"

namespace fretval::plane_answer_test {
namespace {

MdrAnswer answer_to(const Case& scene) {
  const auto mdr = mdr_case(scene);
  return mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
}

/// A circle of the radius of the tangential amplitude.
Case circle(double poisson_ratio = 0.5) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.motion.phase = 0;
  scene.motion.transverse = {{scene.motion.tangential_amplitude, scene.motion.tangential_frequency, 90}};
  scene.contact.vector_friction = true;
  scene.elastomer.poisson_ratio = poisson_ratio;
  return scene;
}

// g(c) = d0 - A with A = 2 (1 - nu)/(2 - nu) u/mu (docs/theory.md).
TEST(PlaneAnswer, OfACircleHasTheDepthOfItsRadius) {
  for (const double nu : {0.5, 0.3}) {
    const auto scene = circle(nu);
    const double demand = 2 * (1 - nu) / (2 - nu) * scene.motion.tangential_amplitude / scene.friction_coefficient,
                 c = std::sqrt(scene.indenter.radius * (scene.motion.indentation - demand));
    const auto answer = answer_to(scene);
    EXPECT_NEAR(answer.stick_radius_shakedown.value() / c, 1, 1e-6) << nu;
    EXPECT_NEAR(answer.stick_radius_first_slip.value() / c, 1, 1e-6) << nu;
    const auto& cycle = answer.cycle.value();
    EXPECT_NEAR(answer.transverse_force_max.value() / cycle.value(Quantity::tangential_force_max), 1, 1e-3);
    EXPECT_GT(cycle.value(Quantity::friction_work), 0);
    EXPECT_LT(cycle.uncertainty(Quantity::friction_work), 0.02 * cycle.value(Quantity::friction_work));
  }
}

// There and back on a line is what the springs of one direction do, by other code.
TEST(PlaneAnswer, OfALineIsThatOfOneDirection) {
  auto scene = circle();
  scene.motion.transverse = {{0.5 * scene.motion.tangential_amplitude, scene.motion.tangential_frequency, 0}};
  auto along = circle();
  along.motion.transverse.clear();
  along.contact = {};
  along.motion.tangential_amplitude *= std::sqrt(1.25);
  const auto plane = answer_to(scene), line = answer_to(along);
  EXPECT_NEAR(plane.stick_radius_shakedown.value() / line.stick_radius_shakedown.value(), 1, 1e-6);
  EXPECT_NEAR(plane.cycle->value(Quantity::friction_work) / line.cycle->value(Quantity::friction_work), 1, 1e-2);
}

// The forces that a circle leads to, prescribed, lead to the circle; under a normal force as by its indentation.
TEST(PlaneAnswer, FollowsForces) {
  auto scene = circle();
  scene.motion.normal_amplitude = 0;
  const auto displaced = answer_to(scene);
  const double u = scene.motion.tangential_amplitude, force = displaced.cycle->value(Quantity::tangential_force_max);
  scene.motion.tangential_amplitude = 0;
  scene.motion.tangential_force = force;
  scene.motion.transverse.front().amplitude = force;
  for (const bool normal : {false, true}) {
    if (normal) {
      scene.motion.normal_force = Case::NormalForce{*displaced.normal_force_max, 0};
      scene.motion.indentation = 0;
    }
    const auto forced = answer_to(scene);
    EXPECT_NEAR(forced.tangential_amplitude.value() / u, 1, 2e-3);
    EXPECT_NEAR(forced.stick_radius_shakedown.value() / displaced.stick_radius_shakedown.value(), 1, 2e-3);
    EXPECT_NEAR(forced.cycle->value(Quantity::friction_work) / displaced.cycle->value(Quantity::friction_work), 1,
                1e-2);
    EXPECT_NEAR(forced.contact_radius_max.value() / displaced.contact_radius_max.value(), 1, 1e-6);
    EXPECT_GT(forced.stepping_error, 0);
    EXPECT_LT(forced.stepping_error, 5e-3);
  }
  scene.motion.tangential_force = 10 * force;
  EXPECT_GT(answer_to(scene).as<GrossSlipShare>()->amplitude, 0);
}

// In a body with memory that is pressed in and out, too; its loops go by other code there.
TEST(PlaneAnswer, OfALineLosesWhatOneDirectionLoses) {
  auto along = circle();
  along.motion.transverse.clear();
  along.contact = {};
  along.motion.normal_amplitude = 0.2 * along.motion.indentation;
  along.motion.phase = 40;
  along.elastomer.rheology = Case::Rheology::standard_solid;
  along.elastomer.branch_moduli = {along.elastomer.relaxed_modulus};
  along.elastomer.branch_times = {0.1 / along.motion.normal_frequency};
  auto scene = along;
  scene.contact.vector_friction = true;
  scene.motion.transverse = {{1e-6 * along.motion.tangential_amplitude, along.motion.tangential_frequency, 40}};
  const auto plane = answer_to(scene).cycle.value(), line = answer_to(along).cycle.value();
  EXPECT_NEAR(plane.value(Quantity::tangential_work) / line.value(Quantity::tangential_work), 1, 1e-2);
  EXPECT_NEAR(plane.value(Quantity::bulk_work) / line.value(Quantity::bulk_work), 1, 2e-2);
  EXPECT_NEAR(plane.value(Quantity::tangential_force_max) / line.value(Quantity::tangential_force_max), 1, 1e-3);
  EXPECT_NEAR(plane.value(Quantity::tangential_force_mean), line.value(Quantity::tangential_force_mean),
              1e-3 * line.value(Quantity::tangential_force_max));
  EXPECT_LT(std::abs(line.value(Quantity::tangential_force_mean)), 0.5 * line.value(Quantity::tangential_force_max));
}

// Under an oscillating normal force the indentation comes from the normal response, instant by instant.
TEST(PlaneAnswer, OfALineUnderANormalForceIsThatOfOneDirection) {
  auto along = circle();
  along.motion.transverse.clear();
  along.contact = {};
  along.motion.normal_force = Case::NormalForce{0.2, 0.05};
  along.motion.indentation = along.motion.normal_amplitude = 0;
  along.motion.phase = 60;
  auto scene = along;
  scene.contact.vector_friction = true;
  scene.motion.transverse = {{1e-6 * along.motion.tangential_amplitude, along.motion.tangential_frequency, 60}};
  const auto plane = answer_to(scene), line = answer_to(along);
  EXPECT_NEAR(plane.stick_radius_shakedown.value() / line.stick_radius_shakedown.value(), 1, 1e-3);
  EXPECT_NEAR(plane.cycle->value(Quantity::tangential_force_mean), line.cycle->value(Quantity::tangential_force_mean),
              1e-3 * line.cycle->value(Quantity::tangential_force_max));
  EXPECT_NEAR(plane.cycle->value(Quantity::friction_work) / line.cycle->value(Quantity::friction_work), 1, 1e-2);
}

// The force on a parabola of constant depth rises to twice what friction bears, from 5 s to 15 s.
TEST(PlaneAnswer, OfAPassSlidesAtATimeOfItsFile) {
  auto scene = circle();
  const double d = scene.motion.indentation,
               force = 16.0 / 3 * scene.elastomer.relaxed_modulus * std::sqrt(scene.indenter.radius * d * d * d);
  Case::Path path{{{5, 15}, {d, d}, {0, 2 * scene.friction_coefficient * force}, false}, "a.csv"};
  path.tangential_force = true;
  path.transverse = {0, 0};
  scene.motion = motion_along(path);
  EXPECT_NEAR(answer_to(scene).as<GrossSlipShare>()->time.value(), 10, 0.05);
}

TEST(PlaneAnswer, IsAskedForTwoDirectionsAlone) {
  EXPECT_TRUE(moves_in_plane(mdr_case(circle())));
  EXPECT_FALSE(moves_in_plane(mdr_case(suite_case("parabola-elastic-steady", 1e-2))));
}

}  // namespace
}  // namespace fretval::plane_answer_test
