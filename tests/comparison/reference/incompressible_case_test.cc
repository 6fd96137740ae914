#include "comparison/reference/incompressible_case.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/suite_case.h"

namespace fretval::incompressible_case_test {
namespace {

TEST(IncompressibleCase, OfAnIncompressibleBodyIsTheCaseItself) {
  const auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const auto [input, displacement] = incompressible_case(scene);
  EXPECT_EQ(displacement, 1);
  EXPECT_EQ(input.elastomer.relaxed_modulus, scene.elastomer.relaxed_modulus);
  EXPECT_EQ(input.motion.tangential_amplitude, scene.motion.tangential_amplitude);
}

// Hertz with E* = 2 G/(1 - nu), F = (4/3) E* sqrt(R d^3), and Cattaneo and Mindlin with
// u_x = mu (2 - nu)/(2 (1 - nu)) (d - c^2/R), F_x = mu (F(a) - F(c)).
TEST(IncompressibleCase, HasTheContactOfTheCompressibleHalfSpace) {
  for (const double nu : {0.0, 0.3, 0.49}) {
    auto scene = suite_case("parabola-elastic-steady", 1e-2);
    scene.elastomer.poisson_ratio = nu;
    const auto mdr = mdr_case(scene);
    const auto answer = mdr_answer_with_cycle(mdr, mdr_normal_response(mdr));
    const double R = scene.indenter.radius, d = scene.motion.indentation, mu = scene.friction_coefficient,
                 E = 2 * scene.elastomer.relaxed_modulus / (1 - nu);
    const auto hertz = [&](double depth) { return 4 * E / 3 * std::sqrt(R * std::pow(depth, 3)); };
    const double stuck = d - scene.motion.tangential_amplitude / (mu * (2 - nu) / (2 * (1 - nu)));
    EXPECT_NEAR(answer.normal_force_max.value() / hertz(d), 1, 1e-9) << nu;
    EXPECT_NEAR(answer.stick_radius_shakedown.value() / std::sqrt(R * stuck), 1, 1e-12) << nu;
    EXPECT_NEAR(answer.cycle->value(Quantity::tangential_force_max) / (mu * (hertz(d) - hertz(stuck))), 1, 1e-3) << nu;
    // Without memory the loop is what friction takes.
    EXPECT_NEAR(answer.cycle->value(Quantity::tangential_work) / answer.cycle->value(Quantity::friction_work), 1, 1e-2)
        << nu;
  }
}

// Of the two directions of the surface either both displacements are stretched or none of the forces is.
TEST(IncompressibleCase, StretchesDisplacementsAndNoForces) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.elastomer.poisson_ratio = 0.3;
  scene.motion.tangential_harmonics = scene.motion.transverse = {{2e-6, 1, 90}};
  const auto stretched = incompressible_case(scene);
  scene.motion.tangential_force = 0.1;
  const auto forced = incompressible_case(scene);
  for (const auto harmonics : {&Case::Motion::tangential_harmonics, &Case::Motion::transverse}) {
    EXPECT_EQ((stretched.input.motion.*harmonics).front().amplitude, 2e-6 * stretched.displacement);
    EXPECT_EQ((forced.input.motion.*harmonics).front().amplitude, 2e-6);
  }
}

TEST(IncompressibleCase, StretchesAPathOfDisplacementsAndNoneOfForces) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.elastomer.poisson_ratio = 0.3;
  scene.motion.path = Case::Path{{{0, 1}, {1e-4, 2e-4}, {3e-6, 4e-6}, false}, "a.csv"};
  scene.motion.path->transverse = {5e-6, 6e-6};
  const auto stretched = incompressible_case(scene);
  EXPECT_NEAR(stretched.displacement, 1.5 * 2 * 0.7 / 1.7, 1e-12) << "3/2 over (2 - nu)/(2 (1 - nu))";
  EXPECT_EQ(stretched.input.motion.path->normal, scene.motion.path->normal);
  EXPECT_EQ(stretched.input.motion.path->tangential[1], 4e-6 * stretched.displacement);
  EXPECT_EQ(stretched.input.motion.path->transverse[1], 6e-6 * stretched.displacement);
  scene.motion.path->tangential_force = true;
  const auto forced = incompressible_case(scene);
  EXPECT_EQ(forced.input.motion.path->tangential, scene.motion.path->tangential);
  EXPECT_EQ(forced.input.motion.path->transverse, scene.motion.path->transverse);
}

// Cattaneo and Mindlin the other way round, of a force that oscillates: it moves the indenter by what would make it.
TEST(IncompressibleCase, HasTheDisplacementOfATangentialForce) {
  for (const double nu : {0.0, 0.3}) {
    auto scene = suite_case("parabola-elastic-steady", 1e-2);
    scene.elastomer.poisson_ratio = nu;
    const double R = scene.indenter.radius, d = scene.motion.indentation, mu = scene.friction_coefficient,
                 E = 2 * scene.elastomer.relaxed_modulus / (1 - nu), u = scene.motion.tangential_amplitude;
    const auto hertz = [&](double depth) { return 4 * E / 3 * std::sqrt(R * std::pow(depth, 3)); };
    scene.motion.tangential_amplitude = 0;
    scene.motion.tangential_force = mu * (hertz(d) - hertz(d - u / (mu * (2 - nu) / (2 * (1 - nu)))));
    const auto mdr = mdr_case(scene);
    EXPECT_NEAR(mdr_answer_with_cycle(mdr, mdr_normal_response(mdr)).tangential_amplitude.value() / u, 1, 2e-3) << nu;
  }
}

// All of the contact sticks: the bulk loses the loop of a disc of radius a, pi 8/(2 - nu) a G'' u^2.
TEST(IncompressibleCase, LosesInTheBulkWhatFrictionDoesNot) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const double nu = 0.3, pi = std::acos(-1.0), G = scene.elastomer.relaxed_modulus,
               u = scene.motion.tangential_amplitude, a = std::sqrt(scene.indenter.radius * scene.motion.indentation),
               f = scene.motion.tangential_frequency;
  scene.elastomer.poisson_ratio = nu;
  scene.elastomer.rheology = Case::Rheology::standard_solid;
  scene.elastomer.branch_moduli = {G};
  scene.elastomer.branch_times = {1 / (2 * pi * f)};  // G'' = G/2
  scene.friction_coefficient = 50;
  const auto mdr = mdr_case(scene);
  const auto cycle = mdr_answer_with_cycle(mdr, mdr_normal_response(mdr)).cycle.value();
  const double loop = pi * 8 / (2 - nu) * a * G / 2 * u * u;
  EXPECT_NEAR(cycle.value(Quantity::bulk_work) / loop, 1, 2e-2);
  EXPECT_NEAR(cycle.value(Quantity::tangential_work) / loop, 1, 2e-2);
}

TEST(IncompressibleCase, LeavesLayersAsTheyAre) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.elastomer.poisson_ratio = 0.3;
  scene.body.shape = Case::Body::Shape::layer;
  EXPECT_EQ(incompressible_case(scene).displacement, 1);
}

}  // namespace
}  // namespace fretval::incompressible_case_test
