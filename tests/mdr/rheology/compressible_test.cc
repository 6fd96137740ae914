#include "mdr/rheology/compressible.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mdr/motion/force_control.h"
#include "mdr/profiles/indentation.h"

namespace fretval::mdr::compressible_test {
namespace {

// Hertz and Cattaneo with Poisson's ratio, as textbooks have them (Johnson, Contact Mechanics, chapters 4 and 7).
TEST(Compressible, EquivalentsHaveTheForcesOfTextbooks) {
  const double G = 3, mu = 0.4, d = 0.5;
  for (const double nu : {0.0, 0.3, 0.45, 0.5}) {
    const double equivalent = incompressible_equivalent(elastic(G), nu).relaxed_modulus,
                 stretch = tangential_stretch(nu);
    EXPECT_NEAR(normal_force(parabola(1), equivalent, d), 8.0 / 3 * G * std::pow(d, 1.5) / (1 - nu), 1e-14);
    const double u = 0.01, a = std::sqrt(d);
    EXPECT_NEAR(tangential_force_full_stick(parabola(1), equivalent, d, stretch * u), 8 * G * a * u / (2 - nu), 1e-14);
    EXPECT_NEAR(d - stick_depth_cattaneo_mindlin(mu, d, stretch * u), 2 * (1 - nu) / (2 - nu) * u / mu, 1e-15);
  }
}

TEST(Compressible, AtOneHalfNothingChangesToTheLastBit) {
  const PronyBody body = prony(1.1, {0.7, 0.3}, {0.1, 0.9}, 0.37), same = incompressible_equivalent(body, 0.5);
  EXPECT_EQ(same.relaxed_modulus, body.relaxed_modulus);
  EXPECT_EQ(same.branch_moduli, body.branch_moduli);
  EXPECT_EQ(same.branch_times, body.branch_times);
  EXPECT_EQ(same.viscosity, body.viscosity);
  EXPECT_EQ(tangential_stretch(0.5), 1);
}

// The whole modulus is scaled, at every frequency, whatever the kind of body.
TEST(Compressible, ScalesTheModulusAtEveryFrequency) {
  for (const Rheology& body : {Rheology(prony(1.1, {0.7}, {0.1}, 0.37)), Rheology(FractionalZener{1, 9, 0.1, 0.6})}) {
    for (const double omega : {0.0, 1.0, 30.0})
      EXPECT_NEAR(
          std::abs(complex_modulus(incompressible_equivalent(body, 0.2), omega) * 1.6 - complex_modulus(body, omega)),
          0, 1e-13);
  }
}

TEST(Compressible, RejectsAnythingElse) {
  EXPECT_THROW(tangential_stretch(-0.1), std::invalid_argument);
  EXPECT_THROW(incompressible_equivalent(elastic(1), 0.6), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::compressible_test
