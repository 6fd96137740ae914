#include "mdr/motion/force_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "mdr/profiles/indentation.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::force_control_test {
namespace {

// A dozen rounding errors, relative.
constexpr double tolerance = 1e-12;

TEST(IndentationForForce, HertzAndConeInClosedForm) {
  for (const double force : {1e-12, 1e-3, 1.0, 1e6}) {
    const double hertz = std::pow(3 * force / (16 * 2e6 * std::sqrt(0.01)), 2.0 / 3);
    EXPECT_NEAR(indentation_for_force(parabola(0.01), 2e6, force), hertz, tolerance * hertz);
    const double sharp = std::sqrt(force * pi * std::tan(0.1) / (8 * 2e6));
    EXPECT_NEAR(indentation_for_force(cone(0.1), 2e6, force), sharp, tolerance * sharp);
  }
  EXPECT_EQ(indentation_for_force(parabola(0.01), 2e6, 0), 0);
}

TEST(IndentationForForce, InvertsTheNormalForceForAnyScale) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const Profile profile = power_law(std::pow(10, 12 * unit(random) - 6), 0.5 + 10 * unit(random));
    const double modulus = std::pow(10, 18 * unit(random) - 3), depth = std::pow(10, 18 * unit(random) - 12);
    const double force = normal_force(profile, modulus, depth);
    ASSERT_NEAR(indentation_for_force(profile, modulus, force), depth, tolerance * depth);
  }
}

TEST(TangentialDisplacementForForce, InvertsCattaneoMindlin) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const Profile profile = power_law(0.1 + unit(random), 0.5 + 4 * unit(random));
    const double mu = 0.1 + unit(random), depth = unit(random);
    // Up to the onset of sliding at 3 mu d/2.
    const double displacement = 1.5 * mu * depth * unit(random);
    const double force = normal_force(profile, 3, depth);
    const double pull = tangential_force_cattaneo_mindlin(profile, 3, mu, depth, displacement);
    ASSERT_NEAR(tangential_displacement_for_force(profile, 3, mu, force, pull), displacement, tolerance * mu * depth);
  }
}

TEST(TangentialDisplacementForForce, HertzInClosedForm) {
  // c/a = (1 - F_x/(mu F))^(1/3), u_x = (3 mu/2)(a^2 - c^2)/R.
  const double force = 2, mu = 0.6, radius = 0.01, modulus = 1e6;
  const double a = std::cbrt(3 * force * radius / (16 * modulus));
  for (const double fraction : {0.0, 0.3, 0.99, 1.0}) {
    const double c = a * std::cbrt(1 - fraction);
    EXPECT_NEAR(tangential_displacement_for_force(parabola(radius), modulus, mu, force, fraction * mu * force),
                1.5 * mu * (a * a - c * c) / radius, 1e-9 * a * a / radius)
        << "near F_x = mu F the cube root turns roundoff into 1e-10";
  }
}

TEST(TangentialDisplacementForForce, SlidingIsAnErrorThatSaysSo) {
  try {
    tangential_displacement_for_force(parabola(1), 1, 0.5, 2, 1.25);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(std::string(error.what()), "tangential force = 1.25: the indenter slides; must be at most mu F = 1");
  }
  EXPECT_THROW(indentation_for_force(parabola(1), 0, 1), std::invalid_argument);
  EXPECT_THROW(indentation_for_force(parabola(1), 1, -1), std::invalid_argument);
  EXPECT_THROW(tangential_displacement_for_force(parabola(1), 1, 0, 1, 0), std::invalid_argument);
  EXPECT_THROW(tangential_displacement_for_force(parabola(1), 1, 1, 1, NAN), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::force_control_test
