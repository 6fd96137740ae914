#include "mdr/layer/layer_stick_radius.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/mdr/error_of.h"

namespace fretval::mdr::layer_stick_radius_test {
namespace {

const double mu = 0.5, G = 2;

Prescribed motion(double d, double normal, double tangential, std::optional<double> phase) {
  return {harmonic_motion({d, normal, tangential, 1, 1, phase})};
}

TEST(LayerStickRadius, OfAThickLayerAreThoseOfTheHalfSpace) {
  const Layer layer{1e6, 0.5};
  for (const std::optional<double> phase : {std::optional<double>(0.0),
                                            std::optional<double>(0.7),
                                            std::optional<double>(1.57),
                                            std::optional<double>(-2.2),
                                            {}}) {
    const Prescribed prescribed = motion(1, 0.15, 0.1, phase);
    const StickRadii layered = layer_stick_radii(parabola(1), layer, G, mu, prescribed),
                     exact = stick_radii(parabola(1), elastic(G), mu, prescribed.motion);
    EXPECT_NEAR(*layered.first_slip, *exact.first_slip, 3e-6);  // a/H
    EXPECT_NEAR(*layered.shakedown, *exact.shakedown, 3e-6);
  }
}

// Two tangents to the loading loop: the force line of mdr/stick/limiting_state.h.
TEST(LayerStickRadius, OfAThickLayerUnderForcesFollowTheTwoTangents) {
  const double F = 1, swing = 0.2, pull = 0.1, phase = 0.9;
  const Prescribed forces{harmonic_motion({F, swing, pull, 1, 1, phase}), true, true};
  const double x = pull / mu * std::cos(phase), y = pull / mu * std::sin(phase);
  const double tangents = F - (std::hypot(x - swing, y) + std::hypot(x + swing, y)) / 2;
  EXPECT_NEAR(*layer_stick_radii(parabola(1), {1e6, 0.5}, G, mu, forces).shakedown, std::cbrt(3 * tangents / 16 / G),
              1e-6);
}

// Without a normal motion a single push of the same size decides, and both radii are one.
TEST(LayerStickRadius, WithoutANormalMotionIsThatOfAPush) {
  for (const Layer& layer : {Layer{2, 0.5}, Layer{0.5, 0.3}}) {
    const LayerContact contact = layer_contact(parabola(1), layer, 1);
    const LayerPush push = layer_push_to_radius(contact, mu, G, 0.7);
    const StickRadii by_displacement =
        layer_stick_radii(parabola(1), layer, G, mu, motion(contact.indentation, 0, push.tangential_displacement, 0.3));
    EXPECT_NEAR(*by_displacement.first_slip, 0.7, 1e-7);
    EXPECT_NEAR(*by_displacement.shakedown, 0.7, 1e-7);
    const StickRadii by_force = layer_stick_radii(
        parabola(1), layer, G, mu,
        {harmonic_motion({normal_force(contact, G), 0, push.tangential_force, 1, 1, 0.3}), true, true});
    EXPECT_NEAR(*by_force.first_slip, 0.7, 1e-7);
    EXPECT_NEAR(*by_force.shakedown, 0.7, 1e-7);
  }
}

TEST(LayerStickRadius, OrdersOfPhaseAreThoseOfTheHalfSpace) {
  const Layer layer{1, 0.5};
  const double d = layer_contact(parabola(1), layer, 1).indentation;
  const auto radii = [&](std::optional<double> phase) {
    return layer_stick_radii(parabola(1), layer, G, mu, motion(d, 0.1 * d, 0.05 * d, phase));
  };
  const StickRadii in_phase = radii(0), quarter = radii(1.5707963267948966), unlocked = radii({});
  EXPECT_LT(*in_phase.first_slip, *quarter.first_slip);
  EXPECT_GT(*in_phase.shakedown, *quarter.shakedown);
  EXPECT_NEAR(*quarter.first_slip, *quarter.shakedown, 1e-8);
  EXPECT_LE(*unlocked.shakedown, *in_phase.first_slip + 1e-8);
}

TEST(LayerStickRadius, NothingSticksUnderAWideMotionOrWhereContactIsLost) {
  const Layer layer{1, 0.5};
  EXPECT_FALSE(layer_stick_radii(parabola(1), layer, G, mu, motion(0.5, 0.01, 5, 0.0)).shakedown);
  EXPECT_FALSE(layer_stick_radii(parabola(1), layer, G, mu, motion(0.5, 0.6, 0.01, 0.0)).shakedown);
  EXPECT_NE(error_of([&] { layer_stick_radii(parabola(1), layer, G, 0, motion(1, 0, 0, 0.0)); }).find("friction"),
            std::string::npos);
}

}  // namespace
}  // namespace fretval::mdr::layer_stick_radius_test
