#include "comparison/simulation/full_case.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/simulation/compute_case.h"
#include "tests/comparison/some_cycle.h"
#include "tests/comparison/suite_case.h"

namespace fretval::full_case_test {
namespace {

Case with_vector_friction(double poisson_ratio, bool coupled = false) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.elastomer.poisson_ratio = poisson_ratio;
  scene.contact = {true, coupled};
  return scene;
}

FeAnswer answer_to(const Case& scene) {
  BodyStore bodies;
  const auto fem = prepare({scene}).front().fem;
  return compute_case(fem, fem.resolution, bodies);
}

FeAnswer ring_answer_to(Case scene) {
  scene.contact = {};
  return answer_to(scene);
}

// Without Poisson's effect responses along and across are equal: the direction of the traction makes no difference.
TEST(FullCase, WithoutPoissonsEffectIsTheRingContact) {
  const auto full = answer_to(with_vector_friction(0)), rings = ring_answer_to(with_vector_friction(0));
  const double a = rings.contact_radius_max.value();
  EXPECT_NEAR(full.stick_radius_shakedown.value(), rings.stick_radius_shakedown.value(), 2e-3 * a);
  EXPECT_NEAR(full.stick_radius_first_slip.value(), rings.stick_radius_first_slip.value(), 2e-3 * a);
  EXPECT_NEAR(full.cycle->value(Quantity::friction_work) / rings.cycle->value(Quantity::friction_work), 1, 1e-2);
  EXPECT_DOUBLE_EQ(full.contact_radius_max.value(), a);
}

// By 0.5 to 4 % (a boundary-element code, docs/theory.md).
TEST(FullCase, OfAnIncompressibleBodySticksWithinLess) {
  const auto full = answer_to(with_vector_friction(0.5)), rings = ring_answer_to(with_vector_friction(0.5));
  EXPECT_LT(full.stick_radius_shakedown.value(), rings.stick_radius_shakedown.value());
  EXPECT_GT(full.stick_radius_shakedown.value(), 0.94 * rings.stick_radius_shakedown.value());
  const auto& surface = std::get<SurfaceAnswer>(full.of_kind);
  EXPECT_NEAR(surface.sticks_in_a_cycle.along / surface.sticks_in_a_cycle.across, 1, 0.02);
  EXPECT_NEAR(surface.sticks_in_a_cycle.area, 3.14159265358979 * std::pow(surface.sticks_in_a_cycle.radius, 2),
              1e-9 * surface.sticks_in_a_cycle.area);
}

// Over an incompressible half-space pressure and friction do not know of each other.
TEST(FullCase, IsCoupledByPoissonsRatio) {
  const auto alone = answer_to(with_vector_friction(0.5)), incompressible = answer_to(with_vector_friction(0.5, true)),
             other = answer_to(with_vector_friction(0.2, true)), other_alone = answer_to(with_vector_friction(0.2));
  const double a = alone.contact_radius_max.value();
  EXPECT_NEAR(incompressible.stick_radius_shakedown.value(), alone.stick_radius_shakedown.value(), 5e-3 * a);
  EXPECT_NEAR(incompressible.normal_force_max / alone.normal_force_max, 1, 2e-3);
  const double change = std::abs(other.normal_force_max / other_alone.normal_force_max - 1);
  EXPECT_GT(change, 1e-3);
  EXPECT_LT(change, 0.03);
}

Case around_a_circle() {
  auto scene = with_vector_friction(0.5);
  scene.motion.phase = 0;
  scene.motion.transverse = {{scene.motion.tangential_amplitude, scene.motion.tangential_frequency, 90}};
  return scene;
}

// A circle sticks within less than MDR's vector springs have, d0 - A.
TEST(FullCase, OfACircleHasNoDirection) {
  const auto scene = around_a_circle();
  const auto answer = answer_to(scene);
  const auto& zone = answer.as<SurfaceAnswer>()->sticks_in_a_cycle;
  EXPECT_NEAR(zone.along / zone.across, 1, 5e-3);
  EXPECT_NEAR(answer.as<SurfaceAnswer>()->transverse_force_max / answer.cycle->value(Quantity::tangential_force_max), 1,
              5e-3);
  const double demand = 2 * scene.motion.tangential_amplitude / (3 * scene.friction_coefficient),
               springs = std::sqrt(scene.indenter.radius * (scene.motion.indentation - demand));
  EXPECT_LT(zone.radius, springs);
  EXPECT_GT(zone.radius, 0.7 * springs);
}

// Over a ring the reading of one mesh goes up and down by 0.17 of a ring.
TEST(FullCase, ReadsAnEdgeAlikeWhereverItLiesInItsRing) {
  auto fem = prepare({around_a_circle()}).front().fem;
  fem.resolution.elements_per_radius = 16;
  BodyStore bodies;
  std::vector<double> edges;
  for (const double third : {0.0, 1.0, 2.0}) {
    auto resolution = fem.resolution;
    resolution.edge_before_node += third / 3;
    edges.push_back(compute_case(fem, resolution, bodies).stick_radius_shakedown.value() / fem.units.length);
  }
  const auto [least, largest] = std::minmax_element(edges.begin(), edges.end());
  EXPECT_GT(*least, 0.5);
  EXPECT_LT(*largest - *least, 0.04 / 16);
}

TEST(FullCase, MovesTheRingsByHalfOfOneWhereItsZonesEnd) {
  auto fem = prepare({around_a_circle()}).front().fem;
  FeAnswer answer;
  answer.contact_radius_max = 1e-3;
  answer.stick_radius_first_slip = 4e-4;
  answer.stick_radius_shakedown = 6e-4;
  const double place = fem.resolution.edge_before_node;
  EXPECT_DOUBLE_EQ(half_a_ring_away(fem, answer)->edge_before_node, place + 0.5 / 0.5);
  answer.stick_radius_first_slip.reset();
  EXPECT_DOUBLE_EQ(half_a_ring_away(fem, answer)->edge_before_node, place + 0.5 / 0.6);
  answer.stick_radius_shakedown.reset();
  EXPECT_FALSE(half_a_ring_away(fem, answer));
  // Along x the ring contact knows the edges better; it does not where pressure and friction are coupled.
  answer.stick_radius_shakedown = 6e-4;
  EXPECT_FALSE(half_a_ring_away(prepare({with_vector_friction(0.3)}).front().fem, answer));
  EXPECT_TRUE(half_a_ring_away(prepare({with_vector_friction(0.3, true)}).front().fem, answer));
}

TEST(FullCase, TakesTheMeanOfTwoAnswers) {
  FeAnswer one, other, none;
  one.of_kind = SurfaceAnswer{
      {12.566370614359172, 2, 2.5, 1.5, 0.1, 0.6, {1.5, 2.5}}, {}, {}, {0, 9, 9, 9, 0.3, 0.3, {9, 9}}, 0, 0, {}, {}};
  other.of_kind = SurfaceAnswer{{0, 4, 4.5, 3.5, 0.4, 0.5, {3.5, 4.5}},
                                {0, 1, 1, 1, 0, 0, {1, 1}},
                                {},
                                {0, 10, 10, 10, 0.2, 0.4, {10, 10}},
                                0,
                                0,
                                {},
                                {}};
  one.contact_radius_max = 9;
  one.normal_force_max = 5;
  other.normal_force_max = 6;
  one.indentation_max = 1;
  other.indentation_max = 4;
  other.tangential_amplitude = 7;  // which the first one does not have
  std::get<SurfaceAnswer>(one.of_kind).torque_max = 2;
  std::get<SurfaceAnswer>(other.of_kind).torque_max = 3;
  one.cycle = some_cycle({10, 0, 5, 0, 5});
  other.cycle = some_cycle({20, 0, 6, 0, 5});
  one.n_steps = 3;
  other.n_steps = 4;
  average(other, one);
  const auto& zones = *one.as<SurfaceAnswer>();
  EXPECT_DOUBLE_EQ(zones.never_slipped.area, 9 * 3.141592653589793);
  EXPECT_EQ(zones.never_slipped.along, 3.5);
  EXPECT_EQ(zones.never_slipped.across, 2.5);
  EXPECT_EQ(zones.never_slipped.uncertainty, 0.4);
  EXPECT_EQ(zones.never_slipped.edge_uncertainty, 0.6);
  EXPECT_EQ(zones.never_slipped.edges, (std::vector<double>{2.5, 3.5}));
  EXPECT_EQ(one.stick_radius_first_slip.value(), 3);
  EXPECT_EQ(one.first_slip_uncertainty, 0.4);
  EXPECT_FALSE(one.stick_radius_shakedown);  // it is none on one of the meshes
  EXPECT_EQ(one.contact_radius_max.value(), 9.5);
  EXPECT_EQ(zones.contact.uncertainty, 0.3);
  EXPECT_EQ(zones.contact.edge_uncertainty, 0.4);
  EXPECT_EQ(zones.torque_max, 2.5);
  EXPECT_EQ(one.normal_force_max, 5.5);
  EXPECT_EQ(one.indentation_max.value(), 2.5);
  EXPECT_FALSE(one.tangential_amplitude);
  EXPECT_EQ(one.cycle->value(Quantity::tangential_force_max), 15);
  EXPECT_EQ(one.cycle->value(Quantity::friction_work), 5.5);
  EXPECT_EQ(one.n_steps, 7);
  none.of_kind = GrossSlipStart{};
  average(none, one);
  EXPECT_EQ(one.n_steps, 7);
}

// To and fro under a constant pressure: the force that a displacement leads to, prescribed, leads to the displacement.
TEST(FullCase, FollowsATangentialForce) {
  auto displaced = with_vector_friction(0.5);
  displaced.motion.normal_amplitude = 0;
  const auto by_displacement = answer_to(displaced);
  auto forced = displaced;
  forced.motion.tangential_amplitude = 0;
  forced.motion.tangential_force = by_displacement.cycle->value(Quantity::tangential_force_max);
  const auto by_force = answer_to(forced);
  const double a = by_displacement.contact_radius_max.value();
  EXPECT_NEAR(by_force.tangential_amplitude.value() / displaced.motion.tangential_amplitude, 1, 1e-2);
  EXPECT_NEAR(by_force.stick_radius_shakedown.value(), by_displacement.stick_radius_shakedown.value(), 1e-2 * a);
}

TEST(FullCase, FollowsForcesAround) {
  auto displaced = with_vector_friction(0.5);
  displaced.motion.normal_amplitude = 0;
  displaced.motion.phase = 0;
  displaced.motion.transverse = {{displaced.motion.tangential_amplitude, displaced.motion.tangential_frequency, 90}};
  const auto by_displacement = answer_to(displaced);
  auto forced = displaced;
  forced.motion.tangential_amplitude = 0;
  forced.motion.tangential_force = by_displacement.cycle->value(Quantity::tangential_force_max);
  forced.motion.transverse.front().amplitude = by_displacement.as<SurfaceAnswer>()->transverse_force_max;
  const auto by_force = answer_to(forced);
  const double a = by_displacement.contact_radius_max.value();
  EXPECT_NEAR(by_force.tangential_amplitude.value() / displaced.motion.tangential_amplitude, 1, 1e-2);
  EXPECT_NEAR(by_force.stick_radius_shakedown.value(), by_displacement.stick_radius_shakedown.value(), 1e-2 * a);
  EXPECT_NEAR(by_force.cycle->value(Quantity::friction_work) / by_displacement.cycle->value(Quantity::friction_work), 1,
              2e-2);
  EXPECT_NEAR(by_force.cycle->sliding_work / by_displacement.cycle->sliding_work, 1, 1e-2);
}

// Pressing with friction is stiffer than without: a compressible body sinks in less far under the same force.
TEST(FullCase, FollowsForcesInBothDirectionsWhereTheyAreCoupled) {
  auto scene = with_vector_friction(0.2, true);
  const double force = ring_answer_to(scene).normal_force_max;
  scene.motion.normal_force = Case::NormalForce{0.75 * force, 0.25 * force};
  scene.motion.normal_amplitude = scene.motion.indentation = scene.motion.tangential_amplitude = 0;
  scene.motion.tangential_force = 0.2 * scene.friction_coefficient * force;
  const auto full = answer_to(scene), rings = ring_answer_to(scene);
  EXPECT_DOUBLE_EQ(full.normal_force_max, rings.normal_force_max);
  EXPECT_NEAR(full.cycle->value(Quantity::tangential_force_max) / *scene.motion.tangential_force, 1, 5e-3);
  const double sinks = full.indentation_max.value() / rings.indentation_max.value();
  EXPECT_LT(sinks, 1 - 1e-3);
  EXPECT_GT(sinks, 0.97);
}

}  // namespace
}  // namespace fretval::full_case_test
