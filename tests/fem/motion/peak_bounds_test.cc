#include "fem/motion/peak_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/support/constants.h"
#include "tests/worse.h"

namespace fretval::fem::peak_bounds_test {
namespace {

template <class Signal>
Eigen::VectorXd samples_of(const Signal& signal, int n, double shift) {
  Eigen::VectorXd samples(n);
  for (int k = 0; k < n; ++k) samples[k] = signal(2 * pi * (k + shift) / n);
  return samples;
}

// A sine up to the instant at which it bends, still rising, and then a parabola of eight times its curvature, of one
// slope there. The parabola has the peak.
struct Bent {
  double bend = 1.4, fall = 8;

  [[nodiscard]] double operator()(double t) const {
    const double after = t - bend;
    if (after < 0 || after > 1) return after < 0 ? std::sin(t) : -10;
    return std::sin(bend) + std::cos(bend) * after - fall / 2 * after * after;
  }
  [[nodiscard]] double peak() const { return std::sin(bend) + std::cos(bend) * std::cos(bend) / (2 * fall); }
};

TEST(PeakBounds, KnowASmoothPeak) {
  for (const double shift : {0.0, 0.3, 0.5, 0.8}) {
    const auto found = peak_bounds(samples_of([](double t) { return 3 + std::cos(t - 1); }, 40, shift));
    EXPECT_NEAR(found.least, 4, 2e-5);
    EXPECT_NEAR(found.most, 4, 2e-5);
  }
}

// Wherever the bend lies in its step the peak is within the bounds, which come together by second order.
TEST(PeakBounds, HoldThePeakOfASignalThatBends) {
  const Bent bent;
  double width[2] = {0, 0};
  for (const int refined : {0, 1})
    for (int k = 0; k < 20; ++k) {
      const auto found = peak_bounds(samples_of(bent, refined ? 128 : 64, k / 20.0));
      EXPECT_LE(found.least, bent.peak());
      EXPECT_GE(found.most, bent.peak() - 1e-4 / (1 + 7 * refined));  // what parabolas of a sine leave
      width[refined] = worse(width[refined], found.most - found.least);
    }
  EXPECT_GT(width[0], 1e-3);
  EXPECT_LT(width[1], width[0] / 3);
}

// A steep rise up to an instant from which on the signal is a cosine that still rises, by more than a step.
TEST(PeakBounds, HoldThePeakOfASignalThatBendsAStepBeforeIt) {
  const double bend = -0.15;
  const auto signal = [&](double t) {
    const double since = std::remainder(t - 3, 2 * pi);
    return std::cos(since) + (since < bend ? 8 * (since - bend) : 0);
  };
  for (int k = 0; k < 20; ++k) {
    const auto found = peak_bounds(samples_of(signal, 64, k / 20.0));
    EXPECT_LE(found.least, 1);
    EXPECT_GE(found.most, 1 - 1e-5) << k;
    EXPECT_LE(found.most - found.least, 3e-3);
  }
}

}  // namespace
}  // namespace fretval::fem::peak_bounds_test
