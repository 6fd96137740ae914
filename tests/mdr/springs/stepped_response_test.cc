#include "mdr/springs/stepped_response.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mdr/profiles/indentation.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::stepped_response_test {
namespace {

// Second order of 400 springs and 360 steps, extrapolated.
constexpr double accuracy = 1e-5;

NormalResponse stepped(const Profile& profile, const PronyBody& body, const HarmonicMotion& motion) {
  return stepped_normal_response([&](double x) { return transform(profile, x); },
                                 inverse_transform(profile, maximum_indentation(motion)), body, motion);
}

// One harmonic, whose response is known exactly; contact is lost at the largest amplitude.
TEST(SteppedResponse, IsTheExactOneForOneHarmonic) {
  for (const PronyBody& body : {elastic(3), standard_solid(3, 6, 0.7), kelvin_voigt(3, 2)})
    for (const double amplitude : {0.05, 0.3}) {
      const Motion motion{0.2, amplitude, 0, 1 / (2 * pi), 1 / (2 * pi), 0.0};
      const auto profile = parabola(5);
      const auto exact =
          periodic_normal_response([&](double x) { return transform(profile, x); },
                                   inverse_transform(profile, maximum_indentation(motion)), body, motion);
      const auto response = stepped(profile, body, harmonic_motion(motion));
      EXPECT_NEAR(response.normal_force_max / exact.normal_force_max, 1, accuracy);
      EXPECT_LT(std::abs(response.normal_force_max - exact.normal_force_max),
                2 * response.normal_force_error + 1e-9 * exact.normal_force_max);
      EXPECT_NEAR(response.normal_force_min / exact.normal_force_max, exact.normal_force_min / exact.normal_force_max,
                  2e-4);
      EXPECT_NEAR(response.contact_radius_max, exact.contact_radius_max, 1e-12);
      ASSERT_EQ(response.axis_pressure.has_value(), exact.axis_pressure.has_value());
      if (exact.axis_pressure) {  // largest between samples, where springs touch
        EXPECT_NEAR(response.axis_pressure->largest / exact.axis_pressure->largest, 1, 2e-4);
      }
    }
}

// p(0) = (4 G/pi) n/(n - 1) d/a, which springs come to with the power n - 1 of their width.
TEST(SteppedResponse, PressureUnderABluntTipIsWithinItsError) {
  const HarmonicMotion motion{0.2, {{0.05, 2, 0.3}, {0.02, 3, 1.1}}, {{1, 5, 0}}};
  for (const double n : {1.3, 1.57, 1.9}) {
    const auto profile = power_law(0.3, n);
    const double d = maximum_indentation(motion), exact = 4 * 3 / pi * n / (n - 1) * d / inverse_transform(profile, d);
    const auto pressure = stepped(profile, elastic(3), motion).axis_pressure.value();
    EXPECT_NEAR(pressure.largest, exact, pressure.error) << n;
    EXPECT_NEAR(pressure.largest / exact, 1, 3e-3) << n;
  }
}

// An elastic body has the static force of every indentation.
TEST(SteppedResponse, ElasticBodyFollowsTheIndentation) {
  const HarmonicMotion motion{0.2, {{0.05, 2, 0.3}, {0.02, 3, 1.1}}, {{1, 5, 0}}};
  const auto profile = cone(0.3);
  const auto response = stepped(profile, elastic(3), motion);
  EXPECT_FALSE(response.axis_pressure);  // a cone
  EXPECT_NEAR(response.normal_force_max / normal_force(profile, 3, maximum_indentation(motion)), 1, accuracy);
  EXPECT_NEAR(response.normal_force_min / normal_force(profile, 3, minimum_indentation(motion)), 1, accuracy);
  EXPECT_DOUBLE_EQ(response.time.back(), 1);
  ASSERT_EQ(response.time.size(), response.normal_force.size());
  for (std::size_t k = 0; k < response.time.size(); k += 50) {
    const double t = 2 * pi * response.time[k], d = 0.2 + 0.05 * std::cos(2 * t + 0.3) + 0.02 * std::cos(3 * t + 1.1);
    EXPECT_NEAR(response.indentation[k], d, 1e-12);
    EXPECT_NEAR(response.normal_force[k] / normal_force(profile, 3, d), 1, 2e-4);
  }
}

}  // namespace
}  // namespace fretval::mdr::stepped_response_test
