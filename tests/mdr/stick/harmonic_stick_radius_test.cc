#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::harmonic_stick_radius_test {
namespace {

// Roundoff of both sides, relative to the lengths that enter.
constexpr double tolerance = 1e-12;

const double mu = 0.4;

std::vector<Rheology> bodies() {
  return {elastic(2), kelvin_voigt(1, 0.1), standard_solid(1, 3, 0.2), FractionalZener{1, 3, 0.1, 0.6}};
}

// Oscillating force of an element as the paper's (15) and (16) have it, harmonic by harmonic, divided by 4 G'(0).
double force(const Rheology& body, const std::vector<Harmonic>& motion, double time) {
  double sum = 0;
  for (const Harmonic& harmonic : motion) {
    const double omega = 2 * pi * harmonic.frequency, angle = omega * time + harmonic.phase;
    const std::complex<double> modulus = complex_modulus(body, omega) / relaxed_modulus(body);
    sum += harmonic.amplitude * (modulus.real() * std::cos(angle) - modulus.imag() * std::sin(angle));
  }
  return sum;
}

// Largest value on [0, period]: every local maximum of a sample is refined.
double maximum_by_sampling(const std::function<double(double)>& f, double period, int n_samples) {
  const double step = period / n_samples;
  double best = -1e300, before = f(-step), here = f(0);
  for (int i = 0; i < n_samples; ++i) {
    const double after = f((i + 1) * step);
    if (here >= before && here >= after) {
      const auto negative = [&](double t) { return -f(t); };
      best =
          std::max(best, -boost::math::tools::brent_find_minima(negative, (i - 1) * step, (i + 1) * step, 40).second);
    }
    before = here;
    here = after;
  }
  return best;
}

struct Demands {
  double forward;
  double backward;
};

Demands demands_by_sampling(const Rheology& body, const HarmonicMotion& motion, double period, int n_samples) {
  const auto demand = [&](double sign) {
    return maximum_by_sampling(
        [&](double t) {
          return sign * 2 / (3 * mu) * force(body, motion.tangential, t) - force(body, motion.normal, t);
        },
        period, n_samples);
  };
  return {demand(1), demand(-1)};
}

void expect_depths(const StickDepths& depths, const HarmonicMotion& motion, const Demands& demands, double relative) {
  const double scale = motion.indentation + demands.forward + demands.backward;
  EXPECT_NEAR(depths.first_slip, motion.indentation - std::max(demands.forward, demands.backward), relative * scale);
  EXPECT_NEAR(depths.shakedown, motion.indentation - (demands.forward + demands.backward) / 2, relative * scale);
}

struct Draw {
  std::mt19937 random{17};
  double operator()() { return std::uniform_real_distribution<double>(0, 1)(random); }
};

TEST(HarmonicStickDepths, EqualFrequenciesReproduceTheClosedForm) {
  Draw draw;
  for (int i = 0; i < 1000; ++i) {
    const Rheology body = bodies()[i % 4];
    const Motion motion{1, draw(), draw(), 2, 2, 8 * draw() - 4};
    const StickDepths closed = stick_depths(body, mu, motion);
    const StickDepths general = stick_depths(body, mu, harmonic_motion(motion));
    // Roundoff alone, relative to the lengths.
    const double scale = 1 + modulus_ratio(body, 4 * pi) * (motion.normal_amplitude + 2 * motion.tangential_amplitude);
    ASSERT_NEAR(general.first_slip, closed.first_slip, 1e-13 * scale);
    ASSERT_NEAR(general.shakedown, closed.shakedown, 1e-13 * scale);
  }
}

TEST(HarmonicStickDepths, TwoFrequenciesAgainstBruteForce) {
  const int ratios[][2] = {{1, 2}, {2, 1}, {1, 3}, {3, 1}, {2, 3}, {3, 2}, {3, 7}, {7, 3}, {5, 8}};
  Draw draw;
  for (const auto& ratio : ratios) {
    for (int i = 0; i < 12; ++i) {
      const Rheology body = bodies()[i % 4];
      const double base = 0.1 + draw();
      const Motion motion{1, 0.3 * draw(), 0.3 * draw(), base * ratio[0], base * ratio[1], 2 * pi * draw()};
      const HarmonicMotion harmonics = harmonic_motion(motion);
      const Demands brute = demands_by_sampling(body, harmonics, 1 / base, 400);
      expect_depths(stick_depths(body, mu, motion), harmonics, brute, tolerance);
    }
  }
}

TEST(HarmonicStickDepths, ManyHarmonicsAgainstBruteForce) {
  Draw draw;
  for (int i = 0; i < 40; ++i) {
    HarmonicMotion motion{1, {}, {}};
    for (const double f : {1.0, 2.0, 5.0}) motion.normal.push_back({0.1 * draw(), f / 3, 2 * pi * draw()});
    for (const double f : {1.0, 3.0, 4.0, 9.0}) motion.tangential.push_back({0.1 * draw(), f / 3, 2 * pi * draw()});
    const Rheology body = bodies()[i % 4];
    const StickDepths depths = stick_depths(body, mu, motion);
    expect_depths(depths, motion, demands_by_sampling(body, motion, 3, 2000), tolerance);
    EXPECT_GE(depths.shakedown, depths.first_slip);

    motion.phase_locked = false;
    const auto tangential = [&](double sign) {
      return maximum_by_sampling([&](double t) { return sign * 2 / (3 * mu) * force(body, motion.tangential, t); }, 3,
                                 2000);
    };
    const double normal = maximum_by_sampling([&](double t) { return -force(body, motion.normal, t); }, 3, 2000);
    expect_depths(stick_depths(body, mu, motion), motion, {tangential(1) + normal, tangential(-1) + normal}, tolerance);
  }
}

// In J cycles the phases come within pi/J of any wanted ones for these worst approximable ratios, up to a factor of
// order one; the demand falls short by half the square of that.
TEST(HarmonicStickDepths, IncommensurateAgainstALongTime) {
  const int n_cycles = 3000;
  for (const double ratio : {std::sqrt(2.0), (1 + std::sqrt(5.0)) / 2}) {
    for (const Rheology& body : bodies()) {
      const Motion motion{1, 0.1, 0.07, 1, ratio, 0.4};
      const HarmonicMotion harmonics = harmonic_motion(motion);
      const Demands brute = demands_by_sampling(body, harmonics, n_cycles, 20 * n_cycles);
      expect_depths(stick_depths(body, mu, motion), harmonics, brute, 10.0 / n_cycles / n_cycles);
      Motion unlocked = motion;
      unlocked.phase.reset();
      EXPECT_NEAR(stick_depths(body, mu, motion).shakedown, stick_depths(body, mu, unlocked).shakedown, tolerance);
    }
  }
}

struct Excess {
  double largest;  // over the phases, of the shakedown depth above the incommensurate one
  double bound;    // (pi^2/2) A D/(A p^2 + D q^2) of mdr/commensurability.h
};

Excess excess_over_incommensurate(int p, int q) {
  const double normal = 0.2, tangential = 0.3, friction = 1;
  const double demand = 2 * tangential / 3;
  const double limit = stick_depths(elastic(1), friction, Motion{1, normal, tangential, 1, 1, std::nullopt}).shakedown;
  Excess excess{0, pi * pi / 2 * demand * normal / (demand * p * p + normal * q * q)};
  for (int i = 0; i < 60; ++i) {
    // The phases repeat after pi/q, where forward and backward change places.
    const Motion motion{1, normal, tangential, double(q), double(p), pi / q * i / 60};
    const double difference = stick_depths(elastic(1), friction, motion).first_slip - limit;
    EXPECT_GE(difference, -tolerance);
    excess.largest = std::max(excess.largest, difference);
  }
  return excess;
}

TEST(HarmonicStickDepths, CommensurateRatiosConvergeToTheIncommensurateOne) {
  // Fibonacci numbers: p/q tends to the golden ratio.
  int p = 5, q = 3;
  Excess last = excess_over_incommensurate(p, q);
  while (p < 1000) {
    const int last_p = p, last_q = q;
    for (int i = 0; i < 3; ++i) q = std::exchange(p, p + q);  // three steps keep odd and even alike
    const Excess excess = excess_over_incommensurate(p, q);
    EXPECT_LE(excess.largest, excess.bound);
    const double order = std::log(last.largest / excess.largest) / std::log(double(q) / last_q);
    RecordProperty("order at " + std::to_string(p) + "/" + std::to_string(q), std::to_string(order));
    // Second order, with a remainder of relative size 1/q^2.
    EXPECT_NEAR(order, 2, 4.0 / (last_q * last_q) + 1e-4) << last_p << '/' << last_q;
    last = excess;
  }
}

TEST(HarmonicStickDepths, BeyondTheLargestOrderTheLossIsAsDocumented) {
  // 10001/10000 counts as incommensurate. Its true demand is known: at this phase the maxima coincide.
  const Motion motion{1, 0.2, 0.3, 10000, 10001, pi};
  EXPECT_NEAR(stick_depths(elastic(1), 1, motion).first_slip, 1 - 0.4, tolerance);
  // And 10000/9999 is searched: no phase is off by more than the bound.
  const Motion within{1, 0.2, 0.3, 9999, 10000, 1.0};
  EXPECT_NEAR(stick_depths(elastic(1), 1, within).first_slip, 1 - 0.4, pi * pi / 2 * 0.1 * 1e-8);
}

TEST(HarmonicStickDepths, PhaseLagAtEachFrequencyMatters) {
  const Motion motion{1, 0.1, 0.1, 1, 2, 0.3};
  const Rheology body = kelvin_voigt(1, 0.1);
  HarmonicMotion without_lag = harmonic_motion(motion);
  for (auto* harmonic : {&without_lag.normal[0], &without_lag.tangential[0]}) {
    const double omega = angular_frequency(harmonic->frequency);
    harmonic->amplitude *= modulus_ratio(body, omega);
  }
  EXPECT_GT(std::abs(stick_depths(body, mu, motion).first_slip - stick_depths(elastic(1), mu, without_lag).first_slip),
            1e-3);
}

TEST(HarmonicStickDepths, SymmetricInTime) {
  Draw draw;
  for (int i = 0; i < 50; ++i) {
    const Rheology body = bodies()[i % 4];
    HarmonicMotion motion{1, {}, {}};
    for (const double f : {1.0, 4.0}) motion.normal.push_back({0.1 * draw(), f, 2 * pi * draw()});
    for (const double f : {2.0, 3.0}) motion.tangential.push_back({0.1 * draw(), f, 2 * pi * draw()});
    const double shift = draw();
    HarmonicMotion later = motion, reversed = motion, opposite = motion;
    for (auto* directions : {&later.normal, &later.tangential})
      for (Harmonic& harmonic : *directions) harmonic.phase += 2 * pi * harmonic.frequency * shift;
    // The force at -t: the lag changes its sign as well.
    for (auto* directions : {&reversed.normal, &reversed.tangential})
      for (Harmonic& harmonic : *directions)
        harmonic.phase =
            -harmonic.phase - 2 * std::arg(complex_modulus_ratio(body, angular_frequency(harmonic.frequency)));
    for (Harmonic& harmonic : opposite.tangential) harmonic.phase += pi;
    const StickDepths depths = stick_depths(body, mu, motion);
    for (const HarmonicMotion& twin : {later, reversed, opposite}) {
      EXPECT_NEAR(stick_depths(body, mu, twin).first_slip, depths.first_slip, tolerance);
      EXPECT_NEAR(stick_depths(body, mu, twin).shakedown, depths.shakedown, tolerance);
    }
  }
}

TEST(HarmonicStickRadii, InvertTheProfile) {
  const Motion motion{1, 0.1, 0.1, 1, 2, 0.3};
  const StickDepths depths = stick_depths(elastic(1), mu, motion);
  for (const StickRadii& radii : {stick_radii(parabola(4), elastic(1), mu, motion),
                                  stick_radii(parabola(4), elastic(1), mu, harmonic_motion(motion))}) {
    EXPECT_NEAR(*radii.first_slip, std::sqrt(4 * depths.first_slip), tolerance);
    EXPECT_NEAR(*radii.shakedown, std::sqrt(4 * depths.shakedown), tolerance);
  }
  EXPECT_FALSE(stick_radii(parabola(4), elastic(1), mu, HarmonicMotion{1, {{1.1, 1, 0}}, {}}).shakedown);
}

TEST(HarmonicStickDepths, RejectBadArguments) {
  EXPECT_THROW(stick_depths(elastic(1), 0, HarmonicMotion{1, {}, {}}), std::invalid_argument);
  EXPECT_THROW(stick_depths(elastic(1), 1, HarmonicMotion{-1, {}, {}}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::harmonic_stick_radius_test
