#include "mdr/stick/path_depths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/springs/path_response.h"
#include "mdr/support/constants.h"
#include "tests/mdr/error_of.h"

namespace fretval::mdr::path_depths_test {
namespace {

constexpr double mu = 0.5;

SampledPath cosines(int n, double phase) {
  SampledPath path{{}, {}, {}, true};
  for (int k = 0; k <= n; ++k) {
    const double t = 2 * pi * (k % n) / n;
    path.time.push_back(static_cast<double>(k) / n);
    path.normal.push_back(1 + 0.2 * std::cos(t));
    path.tangential.push_back(0.15 * std::cos(t + phase));
  }
  return path;
}

// u_x = (3 mu/2)(d - g(c)), whatever is in between.
TEST(PathDepths, AreCattaneosAndMindlinsOfAPull) {
  const SampledPath pull{{0, 1}, {1, 1}, {0.2, 0.5}, false};
  const auto depths = path_stick_depths(elastic(3), mu, pull);
  EXPECT_NEAR(depths.first_slip, 1 - 0.3 / (1.5 * mu), 1e-11);
  EXPECT_FALSE(depths.shakedown);
  EXPECT_NEAR(*stick_radii(parabola(2), elastic(3), mu, pull).first_slip, std::sqrt(2 * depths.first_slip), 1e-12);
}

// The force of a ramp of rate v from rest, of a branch: G1 tau v (1 - e^(-t/tau)), and that of a dashpot, eta v.
TEST(PathDepths, OfARampAreThoseOfItsRelaxingForce) {
  const SampledPath pull{{0, 2, 3}, {1, 1, 1}, {0, 0.2, 0.2}, false};
  const PronyBody body{2, {3}, {0.4}, 0.1};
  const double rate = 0.1, force = 0.2 + 3.0 / 2 * 0.4 * rate * (1 - std::exp(-2 / 0.4)) + 0.1 / 2 * rate;
  EXPECT_NEAR(path_stick_depths(body, mu, pull).first_slip, 1 - force / (1.5 * mu), 1e-11);
}

// Rows on cosines: order 2 in their distance; a dashpot feels the rate, which is constant between rows: order 1. The
// worst of some phases, as it depends on where the extremes lie between rows.
TEST(PathDepths, OfSampledCosinesTendToThoseOfTheOscillation) {
  for (const double viscosity : {0.0, 0.01}) {
    const PronyBody body{1, {1, 0.5}, {0.1, 0.02}, viscosity};
    const auto worst = [&](int n) {
      double error = 0;
      for (int k = 0; k < 40; ++k) {
        const double phase = 0.8 + 0.01 * k;
        const auto exact = stick_depths(body, mu, HarmonicMotion{1, {{0.2, 1, 0}}, {{0.15, 1, phase}}});
        const auto depths = path_stick_depths(body, mu, cosines(n, phase));
        error = std::max(
            {error, std::abs(depths.first_slip - exact.first_slip), std::abs(*depths.shakedown - exact.shakedown)});
      }
      return error;
    };
    const double coarse = worst(64), fine = worst(256);
    EXPECT_NEAR(std::log2(coarse / fine) / 2, viscosity > 0 ? 1 : 2, 0.25);
    EXPECT_LT(fine, viscosity > 0 ? 3e-4 : 1e-4);
  }
}

// The closed form of the periodic state against springs that are stepped from rest until they repeat.
TEST(PathDepths, AreThoseOfTheSteppedSprings) {
  const SampledPath path{{0, 0.2, 0.7, 0.9, 1.4}, {0.9, 1.1, 1.1, 0.85, 0.9}, {-0.1, -0.1, 0.12, 0.05, -0.1}, true};
  for (const auto& body : {elastic(1), PronyBody{1, {1}, {0.1}, 0}, PronyBody{1, {0.3, 0.2}, {0.5, 0.02}, 0}}) {
    const auto depths = path_stick_depths(body, mu, path);
    const auto springs = path_course(parabola(1), body, mu, path, {200, 400, 20}).history;
    EXPECT_NEAR(springs.depths.first_slip, depths.first_slip, 2e-4);  // of the ramp and of samples between the rows
    EXPECT_NEAR(springs.settling_depth, *depths.shakedown, 2e-4);
    EXPECT_GT(*depths.shakedown, depths.first_slip + 1e-3);
  }
}

// N and T at the rows of a period that repeats, and memory that has forgotten its start.
TEST(PathDepths, ResponsesGoOnFromPieceToPieceAndFromPeriodToPeriod) {
  const SampledPath path{{0, 0.2, 0.7, 1}, {0.9, 1.1, 1, 0.9}, {0, 0.1, -0.1, 0}, true};
  const PronyBody body{1, {1, 2}, {0.1, 3}, 0};
  for (const auto direction : {PathDirection::normal, PathDirection::tangential}) {
    const auto pieces = path_response(body, path, direction);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      EXPECT_NEAR(pieces[k](path.time[k + 1] - path.time[k]), pieces[(k + 1) % pieces.size()](0), 1e-13);
  }
}

TEST(PathDepths, RefuseBadArguments) {
  const SampledPath pull{{0, 1}, {1, 1}, {0, 0.5}, false};
  EXPECT_NE(error_of([&] { path_stick_depths(elastic(1), 0, pull); }), "accepted");
  EXPECT_NE(error_of([&] { path_stick_depths(elastic(1), mu, {{0}, {1}, {0}, false}); }), "accepted");
}

}  // namespace
}  // namespace fretval::mdr::path_depths_test
