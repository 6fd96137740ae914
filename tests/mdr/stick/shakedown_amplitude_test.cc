#include "mdr/stick/shakedown_amplitude.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "mdr/stick/stick_radius.h"

namespace fretval::mdr::shakedown_amplitude_test {
namespace {

TEST(ShakedownAmplitude, IsTheInverseOfTheShakedownDepth) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 1000; ++i) {
    const PronyBody body = standard_solid(1e6, 3e6 * unit(random), 0.01 + unit(random));
    Motion motion{1e-4, 2e-5 * unit(random), 0, 2, 2, 6.3 * unit(random)};
    if (i % 5 == 0) motion.tangential_frequency = i % 15 == 0 ? std::sqrt(8.0) : 3;
    if (i % 10 == 0) motion.phase.reset();
    const double depth = 1e-4 * unit(random), mu = 0.1 + unit(random);
    const auto amplitude = tangential_amplitude_for_shakedown(body, mu, motion, depth);
    const double least_demand = modulus_ratio(body, angular_frequency(2)) * motion.normal_amplitude;
    ASSERT_EQ(amplitude.has_value(), motion.indentation - depth > least_demand);
    if (!amplitude) continue;
    motion.tangential_amplitude = *amplitude;
    // Roundoff of d0 - depth, enlarged where the ellipse is thin.
    EXPECT_NEAR(stick_depths(body, mu, motion).shakedown, depth, 1e-12 * motion.indentation);
  }
}

}  // namespace
}  // namespace fretval::mdr::shakedown_amplitude_test
