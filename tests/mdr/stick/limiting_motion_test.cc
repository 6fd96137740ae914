#include "mdr/stick/limiting_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mdr/plane/plane_stick.h"
#include "mdr/profiles/indentation.h"
#include "mdr/stick/limiting_state.h"
#include "mdr/support/constants.h"

namespace fretval::mdr::limiting_motion_test {
namespace {

constexpr double mu = 0.5;

// The closed form for one frequency, in all four rigs.
TEST(LimitingMotion, OfOneFrequencyIsTheLimitingState) {
  for (const Rheology& body : {Rheology(elastic(2)), Rheology(standard_solid(1, 0.5, 0.2))})
    for (const Profile& profile : {parabola(2), cone(0.3)})
      for (const bool normal : {false, true})
        for (const bool tangential : {false, true}) {
          const double mean = normal ? 3 : 0.4, oscillation = 0.1 * mean, pull = tangential ? 0.1 : 0.03;
          FrettingControl control{IndentationControl{mean, oscillation}, TangentialDisplacementControl{pull}, 2, 2,
                                  0.7};
          if (normal) control.normal = NormalForceControl{mean, oscillation};
          if (tangential) control.tangential = TangentialForceControl{pull};
          for (const auto criterion : {StickCriterion::first_slip, StickCriterion::shakedown}) {
            const auto closed = limiting_state(profile, body, mu, control, criterion);
            const auto found = limiting_motion(profile, body, mu, {mean, {{oscillation, 2, 0}}, {{pull, 2, 0.7}}},
                                               normal, tangential, criterion);
            ASSERT_TRUE(closed && found);
            EXPECT_NEAR(found->stick_radius / closed->stick_radius, 1, 1e-9);
            EXPECT_NEAR(maximum_indentation(found->motion) / maximum_indentation(closed->motion), 1, 1e-9);
            EXPECT_NEAR(found->motion.tangential.front().amplitude / closed->motion.tangential_amplitude, 1, 1e-9);
          }
        }
}

// Under two forces the unworn contact of radius c bears F0 - (M+ + M-)/2, M+- = max(+-F_x/mu - Delta F), whatever the
// body (docs/theory.md); the maxima by sampling.
TEST(LimitingMotion, UnderTwoForcesOfAnyFrequenciesDoesNotDependOnTheBody) {
  const double mean = 3, oscillation = 0.4, pull = 0.3, phase = 1.1;
  double forward = 0, backward = 0;
  constexpr int n = 200000;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n, q = pull / mu * std::cos(3 * t + phase), f = oscillation * std::cos(2 * t);
    forward = std::max(forward, q - f);
    backward = std::max(backward, -q - f);
  }
  const HarmonicMotion forces{mean, {{oscillation, 2, 0}}, {{pull, 3, phase}}};
  double deepest = 0;
  for (const Rheology& body : {Rheology(elastic(1)), Rheology(standard_solid(1, 0.5, 0.2))}) {
    const auto found = limiting_motion(parabola(2), body, mu, forces, true, true, StickCriterion::shakedown);
    ASSERT_TRUE(found);
    const double depth = transform(parabola(2), found->stick_radius);
    EXPECT_NEAR(normal_force(parabola(2), 1, depth), mean - (forward + backward) / 2, 1e-7);
    EXPECT_NE(maximum_indentation(found->motion), std::exchange(deepest, maximum_indentation(found->motion)));
  }
}

// A circle of radius u under a constant normal force F on an elastic parabola f = r^2/(2 R): g(c) = d - 2 u/(3 mu), and
// the flat punch of radius c bears F = 8 G (c d - c^3/(3 R)). Then 2 c^3/(3 R) + 2 u c/(3 mu) = F/(8 G).
TEST(LimitingMotion, InACircleUnderAWeight) {
  const double G = 2, R = 2, u = 0.02, F = 3;
  const Rheology body = elastic(G);
  const HarmonicMotion circle{F, {}, {{u, 1, 0}, {u, 1, pi / 2, true}}};
  const auto depth = [&](const HarmonicMotion& motion) {
    return plane_stick_depths(stuck_element(body, mu, motion, 4096)).shakedown;
  };
  const auto found = limiting_motion(parabola(R), body, circle, true, false, depth);
  ASSERT_TRUE(found);
  const double c = found->stick_radius;
  EXPECT_NEAR(2 * c * c * c / (3 * R) + 2 * u * c / (3 * mu), F / (8 * G), 1e-6);
  EXPECT_NEAR(found->motion.indentation, c * c / R + 2 * u / (3 * mu), 1e-6);
}

TEST(LimitingMotion, IsNoneWhereNothingCarriesTheOscillation) {
  EXPECT_FALSE(limiting_motion(parabola(2), elastic(1), mu, {1, {{0.1, 1, 0}}, {{0.6, 2, 0}}}, true, true,
                               StickCriterion::shakedown));
  EXPECT_FALSE(limiting_motion(parabola(2), elastic(1), mu, {0.1, {{0.01, 1, 0}}, {{5, 2, 0}}}, false, true,
                               StickCriterion::shakedown));
}

}  // namespace
}  // namespace fretval::mdr::limiting_motion_test
