#include "mdr/rheology/prony_body.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

#include "mdr/rheology/rheology.h"

namespace fretval::mdr::prony_body_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double roundoff = 1e-14;  // a few operations in double precision

TEST(PronyBody, ElasticBodyIgnoresFrequency) {
  EXPECT_EQ(modulus_ratio(elastic(2e6), 1e5), 1);
  EXPECT_EQ(relaxation(elastic(2e6), 3), 2e6);
}

TEST(PronyBody, KelvinVoigtIsPaper28) {
  for (const double omega : {1e-6, 0.3, 1.0, 40.0, 1e9}) {
    const double expected = std::sqrt(4e12 + 3e5 * 3e5 * omega * omega) / 2e6;
    EXPECT_NEAR(modulus_ratio(kelvin_voigt(2e6, 3e5), omega) / expected, 1, roundoff);
  }
}

TEST(PronyBody, StandardSolidIsPaper29Corrected) {
  const double G1 = 2e6, G2 = 7e6, tau = 0.03;
  for (const double omega : {1e-6, 0.3, 20.0, 400.0, 1e9}) {
    const double x = omega * tau;
    const double expected = std::sqrt((G1 * G1 + (G1 + G2) * (G1 + G2) * x * x) / (1 + x * x)) / G1;
    EXPECT_NEAR(modulus_ratio(standard_solid(G1, G2, tau), omega) / expected, 1, roundoff);
  }
}

// Guard for the misprint: as printed, (29) would tend to 0 instead of G1 + G2.
TEST(PronyBody, LimitsOfSlowAndFastOscillation) {
  const PronyBody body = prony(1, {2, 3}, {0.5, 1});
  EXPECT_EQ(modulus_ratio(body, 0), 1);
  EXPECT_NEAR(modulus_ratio(body, 1e-12), 1, roundoff);
  EXPECT_NEAR(modulus_ratio(body, 1e12), 6, 6 * roundoff);
  EXPECT_NEAR(modulus_ratio(body, 1e200), 6, 6 * roundoff);
  EXPECT_EQ(modulus_ratio(prony(1, {2}, {1e200}), 1e200), 3);  // omega tau overflows
  EXPECT_EQ(modulus_ratio(prony(1, {2}, {1e-200}), 1e-200), 1);
  // Next order of G'': sum G_i omega tau_i for slow, sum G_i/(omega tau_i) for fast oscillation.
  EXPECT_NEAR(complex_modulus(body, 1e-12).imag() / 4e-12, 1, roundoff);
  EXPECT_NEAR(complex_modulus(body, 1e12).imag() / 7e-12, 1, roundoff);
}

// x^2/(1 + x^2) and x/(1 + x^2) as they stand, in fifty digits, for branches up to 24 decades apart.
TEST(PronyBody, AgreesWithFiftyDigits) {
  using Precise = boost::multiprecision::cpp_bin_float_50;
  const double times[] = {1e-12, 1e-6, 0.3, 1e6, 1e12};
  const double moduli[] = {3e9, 4e8, 2e7, 5e6, 1e6};
  for (const double viscosity : {0.0, 0.2}) {
    const PronyBody body = prony(7e5, {moduli, moduli + 5}, {times, times + 5}, viscosity);
    for (int exponent = -12; exponent <= 12; ++exponent) {
      const double omega = 1.7 * std::pow(10, exponent);
      Precise storage = body.relaxed_modulus, loss = Precise(omega) * viscosity;
      for (std::size_t i = 0; i < 5; ++i) {
        const Precise x = Precise(omega) * times[i];
        storage += moduli[i] * x * x / (1 + x * x);
        loss += moduli[i] * x / (1 + x * x);
      }
      const std::complex<double> modulus = complex_modulus(body, omega);
      EXPECT_NEAR(static_cast<double>(modulus.real() / storage), 1, roundoff) << omega;
      EXPECT_NEAR(static_cast<double>(modulus.imag() / loss), 1, roundoff) << omega;
    }
  }
}

// G(omega) = i omega int_0^inf (G(t) - G0) exp(-i omega t) dt + G0: links the two independent functions.
TEST(PronyBody, ComplexModulusIsTheTransformOfTheRelaxation) {
  const PronyBody body = prony(1, {2, 3}, {0.5, 1});
  const double omega = 1.7;
  boost::math::quadrature::gauss_kronrod<double, 31> quadrature;
  const double infinity = 40;  // exp(-40) is below roundoff
  const auto part = [&](double (*wave)(double)) {
    return quadrature.integrate([&](double t) { return (relaxation(body, t) - 1) * wave(omega * t); }, 0.0, infinity,
                                15, 1e-13);
  };
  const std::complex<double> modulus = complex_modulus(body, omega);
  EXPECT_NEAR(modulus.real(), 1 + omega * part(std::sin), 1e-11);  // tolerance of the quadrature
  EXPECT_NEAR(modulus.imag(), omega * part(std::cos), 1e-11);
}

TEST(PronyBody, RatioIsAtLeastOneAndAdds) {
  const PronyBody with_dashpot = prony(1, {2}, {0.5}, 0.3);
  const std::complex<double> difference = complex_modulus(with_dashpot, 4) - complex_modulus(prony(1, {2}, {0.5}), 4);
  EXPECT_NEAR(std::abs(difference - std::complex<double>(0, 1.2)), 0, roundoff);
}

TEST(PronyBody, RejectsBadBodies) {
  EXPECT_THROW(elastic(-1), std::invalid_argument);
  EXPECT_THROW(elastic(nan), std::invalid_argument);
  EXPECT_THROW(kelvin_voigt(1, -1), std::invalid_argument);
  EXPECT_THROW(standard_solid(1, 0, 1), std::invalid_argument);
  EXPECT_THROW(standard_solid(1, 1, nan), std::invalid_argument);
  EXPECT_THROW(prony(1, {1, 2}, {1}), std::invalid_argument);
  EXPECT_THROW(modulus_ratio(PronyBody{1, {1}, {}}, 1), std::invalid_argument);
  EXPECT_THROW(complex_modulus(elastic(1), -1), std::invalid_argument);
  EXPECT_THROW(relaxation(elastic(1), -1), std::invalid_argument);
}

TEST(PronyBody, MaxwellBodyIsNamed) {
  try {
    standard_solid(0, 1, 1);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("Maxwell"), std::string::npos);
  }
}

}  // namespace
}  // namespace fretval::mdr::prony_body_test
