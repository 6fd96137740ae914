#include "fem/full_contact/surface_history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/fem/full_contact/bodies.h"

namespace fretval::fem::surface_history_test {
namespace {

using Eigen::VectorXd;
using full_contact_test::cattaneo_push;
using full_contact_test::hertz_pressure;
using full_contact_test::surface_half_space;

/// A push along x to a displacement, in one cycle of 16 steps.
SurfaceHistory pushed(double nu, double displacement, unsigned n_around, Mirrors mirrors = Mirrors::x_and_y) {
  const auto& surface = surface_half_space(nu, 16);
  const SurfaceOperator op(surface, angular_grid(n_around, mirrors), SurfaceField::tangential);
  const auto rings = ring_problems(surface);
  const LateralMotion push{[=](double t, double) {
                             return ValueAndRate{displacement * t / (2 * pi), displacement / (2 * pi)};
                           },
                           [](double, double) {
                             return ValueAndRate{0, 0};
                           }};
  return vector_friction_history(
      VectorFriction(op, {}, 1, push, 16), [&](long) { return hertz_pressure(surface); }, rings, exactly(1));
}

// Without Poisson's effect the direction of the traction has none either.
TEST(SurfaceHistory, OfAPushWithoutPoissonsEffectIsRoundAndCattaneos) {
  for (const double c : {0.4, 0.6}) {
    const auto history = pushed(0, cattaneo_push(c, 0), 8);
    EXPECT_NEAR(history.never_slipped.radius, c, 3e-3);
    EXPECT_NEAR(history.sticks_in_a_cycle.radius, c, 3e-3);
    EXPECT_NEAR(history.never_slipped.along, history.never_slipped.across, 3e-3);
    EXPECT_NEAR(history.contact.radius, 1, 5e-3);  // ring means, not pressures of the rings
    EXPECT_NEAR(history.forces(0, 15) / (2 * pi / 3), 1 - c * c * c, 1e-3);
  }
}

// A boundary-element code puts the stick radius of an incompressible body 0.5 % below Cattaneo's at c/a = 0.7, and 4 %
// at 0.3 (docs/theory.md).
TEST(SurfaceHistory, OfAPushOfAnIncompressibleBodySticksWithinLessThanCattaneos) {
  const auto wide = pushed(0.5, cattaneo_push(0.7, 0.5), 8), narrow = pushed(0.5, cattaneo_push(0.3, 0.5), 8);
  EXPECT_NEAR(wide.never_slipped.radius / 0.7, 0.995, 3e-3);
  EXPECT_NEAR(narrow.never_slipped.radius / 0.3, 0.96, 1e-2);
}

TEST(SurfaceHistory, DoesNotDependOnTheAnglesThatAreLeftOut) {
  const double push = cattaneo_push(0.5, 0.5);
  const auto quarter = pushed(0.5, push, 8), whole = pushed(0.5, push, 8, Mirrors::none);
  EXPECT_NEAR(quarter.never_slipped.radius, whole.never_slipped.radius, 1e-9);
  EXPECT_NEAR(quarter.never_slipped.along, whole.never_slipped.along, 1e-9);
  EXPECT_NEAR(quarter.sticks_in_a_cycle.across, whole.sticks_in_a_cycle.across, 1e-9);
  EXPECT_NEAR(quarter.dissipated[0], whole.dissipated[0], 1e-9);
}

// The contact is where any pressure has been, whatever is left of it at the end; one cycle has none to be compared to.
TEST(SurfaceHistory, HasTheContactOfTheWholeCycle) {
  const auto& surface = surface_half_space(0, 16);
  const SurfaceOperator op(surface, angular_grid(4, Mirrors::x_and_y), SurfaceField::tangential);
  const LateralMotion rest{[](double, double) {
                             return ValueAndRate{0, 0};
                           },
                           [](double, double) {
                             return ValueAndRate{0, 0};
                           }};
  const auto shrinking = [&](long step) -> VectorXd {
    VectorXd pressure = hertz_pressure(surface);
    if (step >= 8) pressure.tail(pressure.size() - 8).setZero();
    return pressure;
  };
  const auto history =
      vector_friction_history(VectorFriction(op, {}, 1, rest, 16), shrinking, ring_problems(surface), exactly(1));
  EXPECT_NEAR(history.contact.radius, 1, 5e-3);
  EXPECT_EQ(history.periodicity, 1);
}

// To and fro under a constant pressure nothing shakes down: both regions are one, and the second cycle repeats.
TEST(SurfaceHistory, OfMindlinsOscillationHasOneRegionAndItsEnergy) {
  const auto& surface = surface_half_space(0, 16);
  const SurfaceOperator op(surface, angular_grid(4, Mirrors::x_and_y), SurfaceField::tangential);
  const auto rings = ring_problems(surface);
  const double c = 0.6, amplitude = cattaneo_push(c, 0);
  const LateralMotion motion{[=](double t, double) {
                               return ValueAndRate{amplitude * std::sin(t), amplitude * std::cos(t)};
                             },
                             [](double, double) {
                               return ValueAndRate{0, 0};
                             }};
  const auto history = vector_friction_history(
      VectorFriction(op, {}, 1, motion, 96), [&](long) { return hertz_pressure(surface); }, rings, exactly(3));
  EXPECT_EQ(history.n_cycles, 3);
  EXPECT_LT(history.periodicity, 1e-4);  // micro-slip across the push lingers
  EXPECT_NEAR(history.never_slipped.radius, c, 3e-3);
  EXPECT_NEAR(history.sticks_in_a_cycle.radius, c, 3e-3);
  EXPECT_NEAR(history.forces.row(0).maxCoeff() / (2 * pi / 3), 1 - c * c * c, 2e-3);
  // Mindlin and Deresiewicz (Johnson, Contact Mechanics, 7.61), G = mu p0 = a = 1, nu = 0.
  const double force = 2 * pi / 3, share = 1 - c * c * c,
               energy = 9 * force * force * 2 / 10 *
                        (1 - std::pow(1 - share, 5.0 / 3) - 5 * share / 6 * (1 + std::pow(1 - share, 2.0 / 3)));
  EXPECT_NEAR(history.dissipated[2] / energy, 1, 2e-2);
  EXPECT_NEAR(history.tangential_work / history.dissipated[2], 1, 1e-3) << "nothing of it is left in the body";
}

// In phase with the pressure, points shake down beyond where they have never slipped; there |t| comes to its limit in
// every cycle, and micro-slip dies out over many of them without moving the edge.
TEST(SurfaceHistory, TellsPointsThatHaveShakenDownFromThoseThatSlip) {
  const auto& surface = surface_half_space(0.5, 16);
  const SurfaceOperator op(surface, angular_grid(8, Mirrors::x_and_y), SurfaceField::tangential),
      of_rings(surface, angular_grid(1), SurfaceField::tangential);
  const auto rings = ring_problems(surface);
  const LateralMotion motion{[](double t, double) {
                               return ValueAndRate{0.2 * std::sin(t), 0.2 * std::cos(t)};
                             },
                             [](double, double) {
                               return ValueAndRate{0, 0};
                             }};
  const auto pressure = [&](long step) -> VectorXd {
    const double share = 0.7 + 0.3 * std::sin(2 * pi * static_cast<double>(step + 1) / 48);
    return share * hertz_pressure(surface);
  };
  std::vector<SurfaceHistory> histories;
  for (const int n_cycles : {3, 6})
    histories.push_back(
        vector_friction_history(VectorFriction(op, {}, 1, motion, 48), pressure, rings, exactly(n_cycles)));
  EXPECT_GT(histories[1].sticks_in_a_cycle.radius, histories[1].never_slipped.radius + 0.02);
  EXPECT_NEAR(histories[0].sticks_in_a_cycle.radius, histories[1].sticks_in_a_cycle.radius, 2e-3);
  const auto ring = vector_friction_history(VectorFriction(of_rings, {}, 1, motion, 48), pressure, rings, exactly(6));
  EXPECT_NEAR(histories[1].sticks_in_a_cycle.radius / ring.sticks_in_a_cycle.radius, 1, 0.05);
}

}  // namespace
}  // namespace fretval::fem::surface_history_test
