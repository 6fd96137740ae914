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
  BodyStore store{{"counted mesh", [this](const BodySpecification& specification) {
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
