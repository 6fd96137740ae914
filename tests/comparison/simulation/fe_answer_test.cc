#include "comparison/simulation/fe_answer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/computed_case.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

// Where the largest force comes less than a ring before the largest contact, no ring shows how the gap goes on: 5e-4
// off at 24 rings with the edge read from the gap.
TEST(FeAnswer, ForceIsReadFromTheEdgeOverTimeWhereNoRingShowsIt) {
  const auto dashpot = fixed_case("parabola-voigt-0", 24, 48);
  EXPECT_NEAR(simulate_case(dashpot).normal_force_max / exact_answer(dashpot).normal_force_max.value(), 1, 2e-4);
}

// A branch that relaxes while the edge crosses a few rings, and one twenty times as fast: 9e-7 and 1.3e-6 off.
TEST(FeAnswer, ForceFollowsPressuresThatFallWithinTheLastRing) {
  auto branch = fixed_case("parabola-solid-60", 24, 96);
  for (const double faster : {1.0, 20.0}) {
    branch.elastomer.branch_times.front() /= faster;
    branch.elastomer.branch_moduli.front() *= std::sqrt(faster);
    const auto relaxing = simulate_case(branch);
    const double exact = exact_answer(branch).normal_force_max.value();
    EXPECT_NEAR(relaxing.normal_force_max / exact, 1, 3e-6) << faster;
    EXPECT_LT(relaxing.normal_force_uncertainty, 3e-6 * exact) << faster;
  }
}

// What nothing has touched stays where it is, however coarse the step: 4.6e-6 are the rings'. Where free rings lag
// behind the indenter it is 2.9e-3, 3.3e-3 and 2.5e-3 with 12, 24 and 48 steps.
TEST(FeAnswer, ContactRadiusHasNoErrorOfTimeWhereABranchRelaxesWithinAStep) {
  auto scene = read_case();
  scene.indenter = {};
  scene.indenter.shape = Case::Shape::cone;
  scene.indenter.slope_angle = 0.7;
  scene.elastomer.rheology = Case::Rheology::standard_solid;
  scene.elastomer.relaxed_modulus = 1e6;
  scene.elastomer.branch_moduli = {43e6};
  scene.elastomer.branch_times = {0.033 / (2 * 3.14159265358979323846)};
  scene.motion.indentation = 1e-4;
  scene.motion.normal_amplitude = 1.13e-4;
  scene.motion.tangential_amplitude = 1e-6;
  scene.motion.normal_frequency = scene.motion.tangential_frequency = 1;
  scene.steps_per_cycle = 32;
  const auto fe = simulate_case(scene);
  const double exact = exact_answer(scene).contact_radius_max.value();
  EXPECT_NEAR(fe.contact_radius_max.value() / exact, 1, 2e-5);
}

// No radius is read where the flank touches without pressure; that nothing wears there is what is read instead.
TEST(FeAnswer, OfALimitingProfileHasEvidenceThatNothingWears) {
  auto scene = limiting_case(0.5);
  scene.elastomer.branch_moduli = scene.elastomer.branch_times = {};
  scene.rings_per_radius = 16;
  scene.tolerance = 0.05;
  const auto fe = simulate_case(scene);
  EXPECT_FALSE(fe.contact_radius_max);
  ASSERT_TRUE(fe.as<NoWearEvidence>());
  EXPECT_LT(fe.as<NoWearEvidence>()->slip_inside, scene.tolerance);
  EXPECT_LT(fe.as<NoWearEvidence>()->force_outside, scene.tolerance);
  EXPECT_NEAR(fe.as<NoWearEvidence>()->touch_indentation, 1, scene.tolerance);
}

TEST(FeAnswer, OfALimitingProfileThatOnlyMovesNormallyHasNoAmplitude) {
  auto scene = limiting_case(0.5);
  scene.rings_per_radius = 16;
  scene.motion.tangential_amplitude = 0;
  const auto fe = simulate_case(scene);
  EXPECT_EQ(fe.as<NoWearEvidence>()->slip_inside, 0);
  EXPECT_FALSE(fe.as<NoWearEvidence>()->limiting_amplitude);
  EXPECT_FALSE(exact_answer(scene).as<LimitingAnswer>()->amplitude);
}

// The node at c says nothing about c: what does is the amplitude at which finite elements begin to slip inside, found
// from pressures alone, and confirmed by histories a percent below and above it.
// The reading is linear in the amplitude, to roundoff.
TEST(FeAnswer, OfALimitingProfileTurnsToSlipAtTheAmplitudeItIsLimitingFor) {
  auto scene = limiting_case(0.5);
  scene.rings_per_radius = 24;
  scene.tolerance = 1e-3;
  const auto fe = simulate_case(scene);
  const double factor = fe.as<NoWearEvidence>()->limiting_amplitude.value();
  EXPECT_NEAR(factor, 1, scene.tolerance);
  scene.motion.tangential_amplitude = 0.99 * factor * mdr_case(scene).motion.tangential.front().amplitude;
  const auto below = simulate_case(scene);
  scene.motion.tangential_amplitude *= 1.01 / 0.99;
  const auto above = simulate_case(scene);
  EXPECT_LT(below.as<NoWearEvidence>()->slip_inside, 1e-4);
  EXPECT_GT(above.as<NoWearEvidence>()->slip_inside, 1e-3);
  EXPECT_NEAR(below.as<NoWearEvidence>()->limiting_amplitude.value(), 1 / 0.99, 1e-9);
  EXPECT_NEAR(above.as<NoWearEvidence>()->limiting_amplitude.value(), 1 / 1.01, 1e-9);
}

// The contact ends at c, the node of the singular pressure. With coarse steps the flank bears a share of it in passing;
// that is a quantity of its own, and the force is off by what 18 steps are, at any number of rings.
TEST(FeAnswer, OfALimitingProfileForceEndsAtItsStickRadius) {
  const auto error_at = [](double ratio, int steps, double least_outside) {
    auto scene = limiting_case(ratio);
    scene.indenter = {};
    scene.indenter.shape = Case::Shape::cone;
    scene.indenter.slope_angle = 5;
    scene.tolerance = 1e-3;
    scene.rings_per_radius = 24;
    scene.steps_per_cycle = steps;
    const auto fe = simulate_case(scene);
    EXPECT_GT(fe.as<NoWearEvidence>()->force_outside, least_outside);
    return fe.normal_force_max / exact_answer(scene).normal_force_max.value() - 1;
  };
  EXPECT_LT(std::abs(error_at(0.5, 72, 1e-4)), 5e-6);
  EXPECT_LT(std::abs(error_at(0.1, 18, 4e-4)), 3e-4);
}

// On the way to the steady state the outermost rings inside c slip a little, by less than a ring that settles does.
TEST(FeAnswer, OfALimitingProfileFirstSlipIsUncertainByWhatSlipsHardlyAtAll) {
  auto scene = limiting_case(0.25);
  scene.indenter = {};
  scene.indenter.shape = Case::Shape::cone;
  scene.indenter.slope_angle = 7.3;
  scene.elastomer.relaxed_modulus = 0.124;
  scene.elastomer.branch_moduli = {0.0992};
  scene.elastomer.branch_times = {0.036};
  scene.friction_coefficient = 0.17;
  scene.motion.indentation = 7.19e-7;
  scene.motion.normal_amplitude = 8.52e-10;
  scene.motion.normal_frequency = scene.motion.tangential_frequency = 5.435;
  scene.motion.phase = -75.5;
  scene.rings_per_radius = 32;
  scene.steps_per_cycle = 32;
  const auto fe = simulate_case(scene);
  const double c = *fe.stick_radius_shakedown, exact = *exact_answer(scene).stick_radius_first_slip;
  EXPECT_EQ(*fe.stick_radius_first_slip, c);
  EXPECT_LT(exact, (1 - 1e-3) * c);
  EXPECT_LE(c - exact, 2 * fe.first_slip_uncertainty);
  EXPECT_LT(fe.first_slip_uncertainty, 1e-2 * c);
}

// A smaller motion than the one that the profile is limiting for leaves all of the contact sticking, a larger one does
// not.
TEST(FeAnswer, OfAWornProfileFollowsMdrUnderAnotherMotion) {
  Case input = limiting_case(0.5, 2e-6);
  input.elastomer.branch_moduli = input.elastomer.branch_times = {};
  input.rings_per_radius = 32;
  for (const double amplitude : {2e-5, 7e-5}) {
    input.motion.tangential_amplitude = amplitude;
    const auto mdr = mdr_case(input);
    const auto fe = simulate_case(input);
    const auto exact = exact_answer(input);
    const double c = mdr.limiting->stick_radius;
    EXPECT_EQ(exact.wears_no_more(), amplitude < 5e-5);
    EXPECT_NEAR(*fe.stick_radius_shakedown, *exact.stick_radius_shakedown, 1e-4 * c) << amplitude;
    EXPECT_NEAR(*fe.stick_radius_first_slip, *exact.stick_radius_first_slip, 1e-4 * c) << amplitude;
    EXPECT_EQ(fe.as<NoWearEvidence>()->slip_inside > 1e-2, amplitude > 5e-5);
    EXPECT_NEAR(*fe.as<NoWearEvidence>()->limiting_amplitude / exact.as<LimitingAnswer>()->amplitude.value(), 1,
                input.tolerance)
        << amplitude;
  }
}

// The pressure on the axis is continued from the five innermost rings. A flat face that ends among them leaves it open.
TEST(FeAnswer, PressureOnTheAxisIsUnknownUnderAFaceOfFewRings) {
  const auto smooth = read_case(elastic_case());
  auto input = smooth;
  input.indenter.shape = Case::Shape::truncated_sphere;
  const auto uncertainty_with = [&](double flat_radius) {
    input.indenter.flat_radius = flat_radius;
    const auto fe = simulate_case(input);
    EXPECT_TRUE(fe.axis_pressure_max);
    return fe.axis_pressure_uncertainty;
  };
  const double a = simulate_case(smooth).contact_radius_max.value(),
               ring = a / prepare({smooth}).front().fem.resolution.elements_per_radius;
  for (const double rings : {1.5, 3.5, 4.5}) EXPECT_TRUE(std::isinf(uncertainty_with(rings * ring))) << rings;
  EXPECT_EQ(uncertainty_with(0.5 * a), 0);
  EXPECT_EQ(simulate_case(smooth).axis_pressure_uncertainty, 0);
}

// An axis that is touched anew is pressed by a branch for as long as that lasts, which a step does not show.
TEST(FeAnswer, PressureOnTheAxisIsUnknownWhereABranchRelaxesInTheStepInWhichItIsTouched) {
  const auto uncertainty_with = [](double amplitude_over_indentation, double steps_of_relaxation) {
    auto scene = fixed_case("parabola-solid-90", 24, 48);
    scene.motion.normal_amplitude = amplitude_over_indentation * scene.motion.indentation;
    scene.elastomer.branch_times = {steps_of_relaxation / scene.motion.normal_frequency / 48};
    return simulate_case(scene).axis_pressure_uncertainty;
  };
  EXPECT_TRUE(std::isinf(uncertainty_with(1.2, 0.1)));
  EXPECT_EQ(uncertainty_with(1.2, 4), 0);
  EXPECT_EQ(uncertainty_with(0.5, 0.1), 0);
}

// a ~ d^(1/2) under a parabola: the contact radius is known twice as well as the indentation that the force leads to.
TEST(FeAnswer, UnderAForceKnowsTheContactRadiusByTheIndentation) {
  auto scene = fixed_case("parabola-solid-90", 24, 48);
  scene.motion.indentation = scene.motion.normal_amplitude = 0;
  scene.motion.normal_force = Case::NormalForce{0.4, 0.2};
  const auto fe = simulate_case(scene);
  const double share = fe.indentation_uncertainty / fe.indentation_max.value();
  EXPECT_GT(share, 0);
  EXPECT_LT(share, 1e-2);
  EXPECT_NEAR(fe.contact_radius_uncertainty / fe.contact_radius_max.value() / share, 0.5, 1e-3);
}

// What a half-space leaves open of an edge over a layer is a share of a ring, whatever the unit of length.
TEST(FeAnswer, OverALayerKnowsTheContactRadiusToTheSameShareAtAnySize) {
  auto scene = fixed_case("parabola-elastic-steady", 24, 24);
  scene.body.shape = Case::Body::Shape::layer;
  scene.body.thickness = 2e-3;
  scene.motion.tangential_amplitude = 0;
  const auto small = simulate_case(scene);
  for (double* length : {&scene.indenter.radius, &scene.body.thickness, &scene.motion.indentation}) *length *= 1000;
  const auto large = simulate_case(scene);
  EXPECT_GT(small.contact_radius_calibration, 0);
  EXPECT_LT(small.contact_radius_calibration, small.contact_radius_max.value() / 24);
  EXPECT_NEAR(large.contact_radius_calibration / small.contact_radius_calibration, 1000, 1e-3);
}

}  // namespace
}  // namespace fretval
