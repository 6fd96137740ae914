#include "mdr/rheology/fractional_zener.h"

#include <gtest/gtest.h>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

#include "mdr/rheology/prony_body.h"
#include "mdr/rheology/rheology.h"
#include "mdr/support/constants.h"
#include "tests/mdr/synthetic_table.h"

namespace fretval::mdr::fractional_zener_test {
namespace {

using Precise = boost::multiprecision::cpp_bin_float_50;

const double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double roundoff = 1e-14;  // a few operations in double precision

struct PreciseModulus {
  Precise storage, loss;
};

// With c, s = cos, sin(pi alpha/2) and z = (omega tau)^alpha:
//   G' = G0 + G1 z (z + c)/(1 + 2 z c + z^2),   G'' = G1 z s/(1 + 2 z c + z^2)
PreciseModulus precise_modulus(const FractionalZener& body, double omega) {
  const Precise alpha = body.order, angle = boost::math::constants::half_pi<Precise>() * alpha;
  const Precise c = cos(angle), z = pow(Precise(omega) * body.branch_time, alpha);
  const Precise scale = body.branch_modulus * z / (1 + 2 * z * c + z * z);
  return {body.relaxed_modulus + scale * (z + c), scale * sin(angle)};
}

double relative_error(double value, const Precise& exact) {
  return static_cast<double>(abs(value / exact - 1));
}

// Powers lose digits in proportion to the logarithm of their base, log(1e12) = 28.
TEST(FractionalZener, AgreesWithFiftyDigits) {
  for (const double alpha : {0.1, 0.5, 0.9, 1.0}) {
    const FractionalZener body{1.3e6, 2.7e7, 0.02, alpha};
    for (int exponent = -12; exponent <= 12; ++exponent) {
      const double omega = 1.7 * std::pow(10, exponent) / body.branch_time;
      const std::complex<double> modulus = complex_modulus(body, omega);
      const PreciseModulus exact = precise_modulus(body, omega);
      EXPECT_LT(relative_error(modulus.real(), exact.storage), roundoff) << alpha << " " << omega;
      EXPECT_LT(relative_error(modulus.imag(), exact.loss), 10 * roundoff) << alpha << " " << omega;
    }
  }
}

TEST(FractionalZener, OrderOneIsTheStandardSolid) {
  const PronyBody solid = standard_solid(1e6, 3e7, 0.02);
  for (const double omega : log_spaced(1e-12, 1e13, 2)) {
    const std::complex<double> modulus = complex_modulus(FractionalZener{1e6, 3e7, 0.02, 1}, omega);
    EXPECT_NEAR(modulus.real() / complex_modulus(solid, omega).real(), 1, roundoff);
    EXPECT_NEAR(modulus.imag() / complex_modulus(solid, omega).imag(), 1, roundoff);
  }
}

TEST(FractionalZener, LimitsOfSlowAndFastOscillation) {
  for (const double alpha : {0.1, 0.5, 1.0}) {
    const FractionalZener body{2, 6, 1, alpha};
    EXPECT_EQ(complex_modulus(body, 0), 2.0);
    // What is left is G1 (omega tau)^(-+alpha).
    EXPECT_NEAR(std::abs(complex_modulus(body, 1e-12) - 2.0), 0, 6.01 * std::pow(1e-12, alpha));
    EXPECT_NEAR(std::abs(complex_modulus(body, 1e12) - 8.0), 0, 6.01 * std::pow(1e-12, alpha));
    EXPECT_GE(complex_modulus(body, 1e-320).real(), 2);
    EXPECT_TRUE(std::isfinite(std::abs(complex_modulus(body, 1e-320))));
    EXPECT_TRUE(std::isfinite(std::abs(complex_modulus(body, 1e308))));
  }
}

// G'' -> G1 sin(pi alpha/2) (omega tau)^alpha for slow oscillation; next order (omega tau)^alpha.
TEST(FractionalZener, LossGrowsWithThePowerAlpha) {
  for (const double alpha : {0.3, 0.5, 0.9}) {
    const FractionalZener body{2, 6, 0.1, alpha};
    const double x = std::pow(1e-8, 1 / alpha);
    const auto loss = [&](double omega_tau) { return complex_modulus(body, omega_tau / body.branch_time).imag(); };
    EXPECT_NEAR(std::log10(loss(10 * x) / loss(x)), alpha, 1e-7);
    EXPECT_NEAR(loss(x) / (6 * std::sin(pi / 2 * alpha) * 1e-8), 1, 1e-7);
    EXPECT_NEAR(std::log10(loss(10 / x) / loss(1 / x)), -alpha, 1e-7);
  }
}

TEST(FractionalZener, RatioRisesFromOneToTheGlassyOne) {
  const Rheology body = FractionalZener{2, 6, 0.1, 0.4};
  double before = 1;
  for (const double omega : log_spaced(1e-9, 1e12, 2)) {
    const double ratio = modulus_ratio(body, omega);
    EXPECT_GT(ratio, before);
    EXPECT_LT(ratio, 4);
    before = ratio;
  }
}

TEST(FractionalZener, RejectsBadBodies) {
  const struct {
    FractionalZener body;
    const char* named;
  } bodies[] = {
      {{0, 1, 1, 0.5}, "relaxed modulus = 0"},
      {{1, -1, 1, 0.5}, "branch modulus = -1"},
      {{1, 1, 0, 0.5}, "relaxation time = 0"},
      {{1, nan, 1, 0.5}, "branch modulus = nan"},
      {{1, 1, 1, 0}, "fractional order = 0: must be above 0 and at most 1"},
      {{1, 1, 1, 1.1}, "fractional order = 1.1"},
      {{1, 1, 1, nan}, "fractional order = nan"},
  };
  for (const auto& bad : bodies) {
    try {
      complex_modulus(bad.body, 1);
      FAIL() << bad.named;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(bad.named), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(complex_modulus(FractionalZener{1, 1, 1, 0.5}, -1), std::invalid_argument);
  EXPECT_THROW(complex_modulus(FractionalZener{1, 1, 1, 0.5}, nan), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::fractional_zener_test
