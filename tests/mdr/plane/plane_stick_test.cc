#include "mdr/plane/plane_stick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "mdr/stick/stick_radius.h"

namespace fretval::mdr::plane_stick_test {
namespace {

constexpr double mu = 0.5, degree = 3.14159265358979323846 / 180;
const PronyBody solid = prony(1e6, {1e6}, {0.1}, 0);

HarmonicMotion along_x(double phase) {
  return {1e-4, {{2e-5, 1, 0}}, {{1.5e-5, 1, phase}}};
}

StickDepths plane_depths(const Rheology& body, const HarmonicMotion& motion) {
  return plane_stick_depths(stuck_element(body, mu, motion, 8192));
}

// The closed forms of one direction, by other code.
TEST(PlaneStick, OfOneDirectionIsTheUsualOne) {
  for (const double phase : {0.0, 60 * degree, 90 * degree})
    for (const auto& body : {prony(1e6, {}, {}, 0), solid}) {
      const auto usual = stick_depths(Rheology(body), mu, along_x(phase)), plane = plane_depths(body, along_x(phase));
      EXPECT_NEAR(plane.first_slip, usual.first_slip, 1e-11);
      EXPECT_NEAR(plane.shakedown, usual.shakedown, 1e-11);
    }
}

// Under a circle g(c) = d0 - 2 u/(3 mu) |G|/G0, whichever the direction.
TEST(PlaneStick, OfACircleIsThatOfItsRadius) {
  const HarmonicMotion circle{1e-4, {}, {{3e-5, 1, 0}, {3e-5, 1, 90 * degree, true}}};
  const double stiffening = modulus_ratio(Rheology(solid), angular_frequency(1));
  const auto depths = plane_depths(solid, circle);
  EXPECT_NEAR(depths.first_slip, 1e-4 - 2 * 3e-5 * stiffening / (3 * mu), 1e-11);
  EXPECT_NEAR(depths.shakedown, depths.first_slip, 1e-11);
}

// Turned by 45 degrees it is the same motion.
TEST(PlaneStick, DoesNotKnowWhereXIs) {
  const double half = 1.5e-5 / std::sqrt(2), phase = 30 * degree;
  const HarmonicMotion turned{1e-4, {{2e-5, 1, 0}}, {{half, 1, phase}, {half, 1, phase, true}}};
  const auto a = plane_depths(solid, turned), b = plane_depths(solid, along_x(phase));
  EXPECT_NEAR(a.first_slip, b.first_slip, 1e-11);
  EXPECT_NEAR(a.shakedown, b.shakedown, 1e-11);
}

// A push to (3, 4) um asks for as much depth as one of 5 um.
TEST(PlaneStick, OfAPathTakesItsFarthestRow) {
  SampledPath path{{0, 1}, {1e-4, 1e-4}, {0, 3e-6}};
  path.transverse = {0, 4e-6};
  const auto depths = plane_stick_depths(stuck_element(prony(1e6, {}, {}, 0), mu, path, 4));
  EXPECT_NEAR(depths.first_slip, 1e-4 - 2 * 5e-6 / (3 * mu), 1e-15);
}

TEST(PlaneStick, RefusesFrequenciesWithoutACommonCycle) {
  EXPECT_THROW(plane_depths(solid, {1e-4, {{2e-5, 1, 0}}, {{1e-5, std::sqrt(2), 0, true}}}), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::plane_stick_test
