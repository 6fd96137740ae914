#include "mdr/layer/layer_limiting_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/layer/coupled_history.h"
#include "mdr/layer/layer_stick_radius.h"

namespace fretval::mdr::layer_limiting_state_test {
namespace {

const double mu = 0.5;
constexpr StickCriterion criteria[] = {StickCriterion::first_slip, StickCriterion::shakedown};

FrettingControl displacements(double d, double normal, double tangential, std::optional<double> phase) {
  return {IndentationControl{d, normal}, TangentialDisplacementControl{tangential}, 1, 1, phase};
}

TEST(LayerLimitingState, OnAThickLayerIsThatOfTheHalfSpace) {
  const std::vector<FrettingControl> controls{
      displacements(1, 0.1, 0.1, 0.7),
      displacements(1, 0.1, 0.1, {}),
      {NormalForceControl{5, 0.5}, TangentialForceControl{0.5}, 1, 1, 0.4},
      {IndentationControl{1, 0.1}, TangentialForceControl{0.4}, 1, 1, 2.0},
      {NormalForceControl{5, 0.5}, TangentialDisplacementControl{0.1}, 1, 1, -0.4}};
  for (const FrettingControl& control : controls) {
    for (const StickCriterion criterion : criteria) {
      const Rheology body = standard_solid(1, 0.5, 0.2);
      const auto layered = layer_limiting_state(parabola(1), {1e6, 0.5}, body, mu, control, criterion);
      const auto exact = limiting_state(parabola(1), body, mu, control, criterion);
      EXPECT_NEAR(layered->stick_radius, exact->stick_radius, 3e-6);  // a/H
      EXPECT_NEAR(layered->motion.indentation, exact->motion.indentation, 3e-6);
      EXPECT_NEAR(layered->motion.normal_amplitude, exact->motion.normal_amplitude, 3e-6);
      EXPECT_NEAR(layered->motion.tangential_amplitude, exact->motion.tangential_amplitude, 3e-6);
      EXPECT_NEAR(layered->mean_normal_force, exact->mean_normal_force, 3e-5);
      EXPECT_NEAR(layered->normal_force_amplitude, exact->normal_force_amplitude, 3e-5);
      EXPECT_NEAR(layered->tangential_force_amplitude, exact->tangential_force_amplitude, 3e-5);
      EXPECT_NEAR(layered->motion.phase.value_or(0), exact->motion.phase.value_or(0), 1e-14);
    }
  }
}

TEST(LayerLimitingState, FourControlsMeetInOneState) {
  const Layer layer{0.8, 0.45};
  const Rheology body = standard_solid(1, 0.5, 0.2);
  const double lag = std::arg(complex_modulus(body, angular_frequency(1)));
  for (const StickCriterion criterion : criteria) {
    const auto state =
        *layer_limiting_state(parabola(1), layer, body, mu, displacements(0.5, 0.04, 0.05, 0.7), criterion);
    const NormalForceControl pressed{state.mean_normal_force, state.normal_force_amplitude};
    const TangentialForceControl pulled{state.tangential_force_amplitude};
    const IndentationControl held{0.5, 0.04};
    const TangentialDisplacementControl moved{0.05};
    for (const FrettingControl& control :
         {FrettingControl{pressed, pulled, 1, 1, 0.7}, FrettingControl{held, pulled, 1, 1, 0.7 + lag},
          FrettingControl{pressed, moved, 1, 1, 0.7 - lag}})
      EXPECT_NEAR(layer_limiting_state(parabola(1), layer, body, mu, control, criterion)->stick_radius,
                  state.stick_radius, 1e-10);
  }
}

// Springs of the worn contact, which end at c, stepped from rest under the motion of the state: nothing slips under
// 0.99 of it once it has shaken down, and the edge does under a little more. The rheology is in the bargain.
TEST(LayerLimitingState, IsTheEdgeOfSlipOfTheWornContact) {
  for (const Layer& layer : {Layer{0.5, 0.5}, Layer{1, 0.3}}) {
    const double d = layer_contact(parabola(1), layer, 1).indentation;
    for (const PronyBody& body : {elastic(1), standard_solid(1, 0.5, 0.2)}) {
      for (const double phase : {0.0, 0.7}) {
        const auto state = *layer_limiting_state(parabola(1), layer, Rheology(body), mu,
                                                 displacements(d, 0.05 * d, 0.3 * d, phase), StickCriterion::shakedown);
        const CoupledBed bed = coupled_bed(spring_bed(parabola(1), state.stick_radius, 200), layer);
        const auto work = [&](double share) {
          const HarmonicMotion motion = harmonic_motion({d, 0.05 * d, share * 0.3 * d, 1, 1, phase});
          return coupled_history(bed, body, mu, {ramped_path(motion, 20), {}, {}}, {1, 120, 20, 400, 1e-10})
              .friction_work;
        };
        const double slides = work(1.03);
        EXPECT_GT(slides, 1e-7);
        EXPECT_LT(work(0.98), 1e-3 * slides);
      }
    }
  }
}

// Under displacements and under both forces wear never makes the stick zone larger than it is in the unworn contact, so
// that it gets to the limiting state; nor does it make much of a difference.
TEST(LayerLimitingState, LiesAShadeBelowTheUnwornRadius) {
  for (const double nu : {0.0, 0.3, 0.5}) {
    for (const double thickness : {5.0, 1.0, 0.5}) {
      const Layer layer{thickness, nu};
      const LayerContact contact = layer_contact(parabola(1), layer, 1);
      const double d = contact.indentation, F = normal_force(contact, 1);
      const double A = 0.3 * d * mu * spring_modulus_ratio(nu);
      const auto worn = layer_limiting_state(parabola(1), layer, elastic(1), mu, displacements(d, 0.1 * d, A, 0.7),
                                             StickCriterion::shakedown);
      const StickRadii unworn =
          layer_stick_radii(parabola(1), layer, 1, mu, {harmonic_motion({d, 0.1 * d, A, 1, 1, 0.7})});
      EXPECT_LE(worn->stick_radius, *unworn.shakedown);
      EXPECT_GT(worn->stick_radius, 0.99 * *unworn.shakedown);
      const FrettingControl forces{NormalForceControl{F, 0.1 * F}, TangentialForceControl{0.3 * mu * F}, 1, 1, 0.7};
      const auto under_forces =
          layer_limiting_state(parabola(1), layer, elastic(1), mu, forces, StickCriterion::shakedown);
      const StickRadii unworn_forces = layer_stick_radii(
          parabola(1), layer, 1, mu, {harmonic_motion({F, 0.1 * F, 0.3 * mu * F, 1, 1, 0.7}), true, true});
      EXPECT_LE(under_forces->stick_radius, *unworn_forces.shakedown + 1e-6);
      EXPECT_GT(under_forces->stick_radius, 0.98 * *unworn_forces.shakedown);
    }
  }
}

TEST(LayerLimitingState, EdgeRatiosTendToOne) {
  EXPECT_NEAR(edge_ratios({1e5, 0.5}, 1).beta, 1, 2e-5);
  EXPECT_NEAR(edge_ratios({1e5, 0.5}, 1).gamma, 1, 1e-9);  // of third order in a/H
  EXPECT_NEAR(edge_ratios({10, 0.5}, 0.75).gamma - 1, 3e-4, 5e-5);
  EXPECT_LT(edge_ratios({1, 0.5}, 0.75).beta, 0.6);
}

TEST(LayerLimitingState, IsEmptyWhereWearGoesOnAndRejectsBadControls) {
  const auto state = [](double m, const FrettingControl& control) {
    return layer_limiting_state(parabola(1), {1, 0.5}, elastic(1), m, control, StickCriterion::shakedown);
  };
  EXPECT_FALSE(state(mu, displacements(1, 1.1, 0.01, 0.0)));
  EXPECT_FALSE(state(mu, displacements(1, 0.1, 100, 0.0)));
  EXPECT_THROW(state(0, displacements(1, 0.1, 0.1, 0.0)), std::invalid_argument);
  EXPECT_THROW(state(mu, displacements(0, 0.1, 0.1, 0.0)), std::invalid_argument);
  EXPECT_THROW(state(mu, {IndentationControl{1, 0}, TangentialForceControl{1}, 1, 2, 0.0}), std::invalid_argument);
  EXPECT_THROW(layer_limiting_state(parabola(1), {1, 0.5, LayerBase::frictionless}, elastic(1), mu,
                                    displacements(1, 0.1, 0.1, 0.0), StickCriterion::shakedown),
               std::invalid_argument);
}

}  // namespace
}  // namespace fretval::mdr::layer_limiting_state_test
