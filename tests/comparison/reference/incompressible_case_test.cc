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
    EXPECT_NEAR(answer.cycle->tangential_force_max / (mu * (hertz(d) - hertz(stuck))), 1, 1e-3) << nu;
    // Without memory the loop is what friction takes.
    EXPECT_NEAR(answer.cycle->tangential_work / answer.cycle->friction_work, 1, 1e-2) << nu;
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

TEST(IncompressibleCase, LeavesLayersAsTheyAre) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.elastomer.poisson_ratio = 0.3;
  scene.body.shape = Case::Body::Shape::layer;
  EXPECT_EQ(incompressible_case(scene).displacement, 1);
}

}  // namespace
}  // namespace fretval::incompressible_case_test
