#include "comparison/simulation/compute_case.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/accuracy/prepared_case.h"
#include "tests/comparison/suite_case.h"

namespace fretval {
namespace {

/// Bodies whose meshes are counted.
struct CountedBodies {
  int n_meshes = 0;
  BodyStore store{{"counted mesh", [this](const BodyDescription& specification) {
                     ++n_meshes;
                     return mesh_of(specification);
                   }}};
};

const Resolution coarse_resolution{16, 2, 0.5, 10, 16, 1, 1e-3};

// Hertz: F = 16/3 G sqrt(R d^3), a = sqrt(R d); Cattaneo and Mindlin: u_x0 = 3/2 mu (d - c^2/R).
TEST(ComputeCase, IsCattaneosAndMindlinsProblemForASteadyElasticSphere) {
  const auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const auto fem = prepare({scene}).front().fem;
  BodyStore bodies;
  const auto fe = compute_case(fem, coarse_resolution, bodies);
  const double R = scene.indenter.radius, d = scene.motion.indentation, G = scene.elastomer.relaxed_modulus;
  const double stuck_depth = d - scene.motion.tangential_amplitude / (1.5 * scene.friction_coefficient);
  constexpr double discretisation = 2e-3;  // of 16 rings
  EXPECT_NEAR(fe.contact_radius_max.value() / std::sqrt(R * d), 1, discretisation);
  EXPECT_NEAR(fe.normal_force_max / (16 * G / 3 * std::sqrt(R * d * d * d)), 1, discretisation);
  EXPECT_NEAR(fe.stick_radius_first_slip.value() / std::sqrt(R * stuck_depth), 1, 2 * discretisation);
  EXPECT_NEAR(fe.stick_radius_shakedown.value() / std::sqrt(R * stuck_depth), 1, 2 * discretisation);
  EXPECT_EQ(fe.rings.contact, 16);
}

/// The same, under the normal force of d and the tangential one of the stick radius.
Case under_forces(const Case& scene, double stick_share) {
  const double R = scene.indenter.radius, G = scene.elastomer.relaxed_modulus;
  const double force = 16 * G / 3 * std::sqrt(R * std::pow(scene.motion.indentation, 3));
  Case input = scene;
  input.motion.normal_force = {force, 0};
  input.motion.tangential_force = scene.friction_coefficient * force * (1 - std::pow(stick_share, 3));
  return input;
}

// d and u_x from F and F_x: c/a = (1 - F_x/(mu F))^(1/3).
TEST(ComputeCase, IsCattaneosAndMindlinsProblemUnderForcesToo) {
  const auto scene = suite_case("parabola-elastic-steady", 1e-2);
  constexpr double share = 0.6, discretisation = 2e-3;
  const auto fem = prepare({under_forces(scene, share)}).front().fem;
  BodyStore bodies;
  const auto fe = compute_case(fem, coarse_resolution, bodies);
  const double d = scene.motion.indentation, a = std::sqrt(scene.indenter.radius * d);
  EXPECT_NEAR(fe.indentation_max.value() / d, 1, discretisation);
  EXPECT_NEAR(fe.contact_radius_max.value() / a, 1, discretisation);
  EXPECT_NEAR(fe.stick_radius_first_slip.value() / a, share, 2 * discretisation);
  EXPECT_NEAR(fe.stick_radius_shakedown.value() / a, share, 2 * discretisation);
  // Sixteen steps see the reversal to (2 pi/16)^2/8.
  EXPECT_NEAR(fe.tangential_amplitude.value() / (1.5 * scene.friction_coefficient * d * (1 - share * share)), 1, 2e-2);
}

// |F_x| = 1.25 mu F: all slides as soon as the ramp comes to 0.8 of it, at the next peak at the latest.
TEST(ComputeCase, SaysWhenAllOfTheContactSlides) {
  auto input = under_forces(suite_case("parabola-elastic-steady", 1e-2), 0.6);
  input.motion.tangential_force = 1.25 * input.friction_coefficient * input.motion.normal_force->mean;
  const auto fem = prepare({input}).front().fem;
  BodyStore bodies;
  const auto fe = compute_case(fem, coarse_resolution, bodies);
  ASSERT_TRUE(fe.as<GrossSlipStart>());
  EXPECT_GE(fe.as<GrossSlipStart>()->amplitude, 0.8 - 1e-3);
  EXPECT_LE(fe.as<GrossSlipStart>()->amplitude, 1);
  EXPECT_LE(fe.as<GrossSlipStart>()->time, 2 / input.motion.tangential_frequency);
  EXPECT_FALSE(fe.stick_radius_shakedown || fe.contact_radius_max);
  EXPECT_GT(fe.body->n_dofs, 0);
}

TEST(ComputeCase, SharesBodiesOfCasesThatDifferInNoMesh) {
  CountedBodies bodies;
  const auto steady = prepare({suite_case("parabola-elastic-steady", 1e-2)}).front().fem,
             moving = prepare({suite_case("cone-elastic-0", 1e-2)}).front().fem,
             at_rest = prepare({suite_case("at-rest-parabola", 1e-2)}).front().fem;
  const auto first = compute_case(steady, coarse_resolution, bodies.store);
  const auto second = compute_case(moving, with_steps(coarse_resolution, 2), bodies.store);
  EXPECT_EQ(bodies.n_meshes, 1);
  EXPECT_EQ(first.body, second.body);
  compute_case(at_rest, coarse_resolution, bodies.store);
  EXPECT_EQ(bodies.n_meshes, 2) << "another one without a tangential harmonic";
  compute_case(steady, with_rings(coarse_resolution, 1.5), bodies.store);
  EXPECT_EQ(bodies.n_meshes, 3);
}

// Without tangential motion all of the contact sticks, as far as it is never left.
TEST(ComputeCase, NothingSlipsWithoutTangentialMotion) {
  const auto scene = suite_case("at-rest-parabola", 1e-2);
  const auto fem = prepare({scene}).front().fem;
  BodyStore bodies;
  const auto fe = compute_case(fem, coarse_resolution, bodies);
  const double smallest = std::sqrt(scene.indenter.radius * (scene.motion.indentation - scene.motion.normal_amplitude));
  EXPECT_NEAR(fe.stick_radius_shakedown.value() / smallest, 1, 1e-2);
  EXPECT_EQ(fe.friction.period_slip.maxCoeff(), 0);
}

}  // namespace
}  // namespace fretval
