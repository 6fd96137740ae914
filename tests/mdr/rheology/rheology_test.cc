#include "mdr/rheology/rheology.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fretval::mdr::rheology_test {
namespace {

constexpr double roundoff = 1e-14;

// Of order 1 the spring-pot is a dashpot: both kinds of body describe the same standard solid.
TEST(Rheology, BothKindsOfAStandardSolidAgree) {
  const Rheology branches = standard_solid(2e6, 3e6, 0.1), spring_pot = FractionalZener{2e6, 3e6, 0.1, 1};
  for (const double omega : {0.0, 0.7, 10.0, 1e5}) {
    EXPECT_NEAR(std::abs(complex_modulus(branches, omega) / complex_modulus(spring_pot, omega) - 1.0), 0, roundoff);
    EXPECT_NEAR(modulus_ratio(branches, omega) / modulus_ratio(spring_pot, omega), 1, roundoff);
  }
  EXPECT_EQ(relaxed_modulus(branches), 2e6);
  EXPECT_EQ(relaxed_modulus(spring_pot), 2e6);
}

// omega tau = 1: G = G0 + G1/2 (1 + i), so 3.5 + 1.5 i over 2.
TEST(Rheology, RatioHasMagnitudeAndLagOfTheModulus) {
  const Rheology body = standard_solid(2e6, 3e6, 0.1);
  EXPECT_NEAR(complex_modulus_ratio(body, 10).real(), 1.75, roundoff);
  EXPECT_NEAR(complex_modulus_ratio(body, 10).imag(), 0.75, roundoff);
  EXPECT_NEAR(modulus_ratio(body, 10), std::hypot(1.75, 0.75), roundoff);
}

TEST(Rheology, RatioIsOneAtRestAndGrowsToTheGlassyOne) {
  for (const Rheology& body :
       {Rheology(standard_solid(2e6, 3e6, 0.1)), Rheology(FractionalZener{2e6, 3e6, 0.1, 0.6})}) {
    EXPECT_EQ(complex_modulus_ratio(body, 0), 1.0);
    double before = 1;
    for (double omega = 1e-3; omega < 1e5; omega *= 3) {
      EXPECT_GT(modulus_ratio(body, omega), before) << omega;
      before = modulus_ratio(body, omega);
    }
    EXPECT_NEAR(modulus_ratio(body, 1e30), 2.5, roundoff);
  }
}

TEST(Rheology, RejectsWhatItsBodyRejects) {
  EXPECT_THROW(modulus_ratio(elastic(1), -1), std::invalid_argument);
  EXPECT_THROW(modulus_ratio(FractionalZener{1, 1, 1, 0.5}, -1), std::invalid_argument);
  EXPECT_THROW(complex_modulus_ratio(PronyBody{0, {1}, {1}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::rheology_test
