#include "mdr/rheology/time_temperature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

namespace fretval::mdr::time_temperature_test {
namespace {

const double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double roundoff = 1e-14;  // a few operations in double precision

const Rheology prony_body = prony(1e6, {2e6, 3e7}, {1e-5, 0.3}, 2e3);
const Rheology fractional_body = FractionalZener{1e6, 3e7, 0.02, 0.4};

TEST(TimeTemperature, ReferenceTemperatureShiftsNothing) {
  EXPECT_EQ(wlf_shift(17.44, 51.6, 300, 300), 1);
  EXPECT_EQ(complex_modulus(shifted(prony_body, 1), 4), complex_modulus(prony_body, 4));
}

// c1 is the shift infinitely far above; half of it is reached at T - T_r = c2.
TEST(TimeTemperature, WlfAtKnownPoints) {
  EXPECT_NEAR(wlf_shift(8, 100, 20, 120) / 1e-4, 1, roundoff);
  EXPECT_NEAR(wlf_shift(8, 100, 20, 1e12) / 1e-8, 1, 1e-8);  // c1 c2 ln(10)/T is left
  EXPECT_NEAR(wlf_shift(8, 100, 20, -30) / 1e8, 1, 10 * roundoff);
  EXPECT_GT(wlf_shift(8, 100, 20, 19), 1);
}

// The same curve seen from another reference: c2' = c2 + T' - T, c1' = c1 c2/c2', Ferry (1980), chapter 11.
TEST(TimeTemperature, ShiftsCompose) {
  const double c1 = 8.86, c2 = 101.6, there = 35;
  const double direct = wlf_shift(c1, c2, 20, 80);
  const double by_way =
      wlf_shift(c1, c2, 20, there) * wlf_shift(c1 * c2 / (c2 + there - 20), c2 + there - 20, there, 80);
  EXPECT_NEAR(by_way / direct, 1, 10 * roundoff);
}

TEST(TimeTemperature, ShiftedBodyIsTheBodyAtAnotherFrequency) {
  for (const Rheology& body : {prony_body, fractional_body}) {
    for (const double a : {1e-7, 0.3, 4.0, 1e9}) {
      for (const double omega : {1e-3, 1.0, 50.0, 1e6}) {
        const std::complex<double> expected = complex_modulus(body, a * omega);
        EXPECT_NEAR(std::abs(complex_modulus(shifted(body, a), omega) - expected) / std::abs(expected), 0, roundoff);
      }
    }
    EXPECT_EQ(relaxed_modulus(shifted(body, 1e3)), relaxed_modulus(body));
  }
}

TEST(TimeTemperature, NamesThePole) {
  for (const double temperature : {-80.0, -81.0, std::nextafter(-80.0, 0)}) {
    try {
      wlf_shift(8, 100, 20, temperature);
      FAIL() << temperature;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find("pole of the WLF equation, -80"), std::string::npos) << error.what();
    }
  }
}

TEST(TimeTemperature, RejectsBadArguments) {
  EXPECT_THROW(wlf_shift(0, 100, 20, 30), std::invalid_argument);
  EXPECT_THROW(wlf_shift(8, -1, 20, 30), std::invalid_argument);
  EXPECT_THROW(wlf_shift(8, 100, nan, 30), std::invalid_argument);
  EXPECT_THROW(wlf_shift(8, 100, 20, nan), std::invalid_argument);
  EXPECT_THROW(shifted(prony_body, 0), std::invalid_argument);
  EXPECT_THROW(shifted(fractional_body, nan), std::invalid_argument);
  EXPECT_THROW(shifted(prony_body, 1e-322), std::invalid_argument);  // a time vanishes
}

}  // namespace
}  // namespace fretval::mdr::time_temperature_test
