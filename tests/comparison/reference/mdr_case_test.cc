#include "comparison/reference/mdr_case.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "comparison/reference/mdr_answer.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"

namespace fretval::mdr_case_test {
namespace {

TEST(MdrCase, LimitingStateHasItsStickRadiusAsShakedownRadius) {
  const auto mdr = mdr_case(limiting_case(0.6, 2e-6));
  const auto answer = mdr_answer(mdr, mdr_normal_response(mdr));
  EXPECT_NEAR(*answer.stick_radius_shakedown / mdr.limiting->stick_radius, 1, 1e-12);
}

TEST(MdrCase, SaysWhenNoAmplitudeShakesDown) {
  expect_parts(refusal([] { mdr_case(limiting_case(0.95)); }), {"Stick radius ratio = 0.95"});
}

// All of a flat face sticks or nothing, and which of them roundoff would decide.
TEST(MdrCase, LimitingStateCannotStickInsideAFlatFace) {
  Case input = limiting_case(0.2, 2e-6);
  input.indenter.shape = Case::Shape::rounded_flat;
  input.indenter.flat_radius = input.indenter.edge_radius = 1e-3;
  expect_parts(refusal([&] { mdr_case(input); }), {"inside the flat face"});
  input.worn_stick_ratio = 0.95;
  EXPECT_EQ(refusal([&] { mdr_case(input); }), "no error");
}

TEST(MdrCase, NamesTheEntryThatOnlyTheReferenceCovers) {
  EXPECT_TRUE(is_comparable(read_case()));
  Case forced = read_case();
  forced.motion.normal_force = {1, 0.1};
  forced.motion.tangential_force = 0.1;
  EXPECT_TRUE(is_comparable(forced));
  const auto expect_refused = [](const char* entry, const std::function<void(Case::Motion&)>& change) {
    Case input = read_case();
    change(input.motion);
    EXPECT_FALSE(is_comparable(input)) << entry;
    expect_parts(refusal([&] { mdr_case(input); }), {"case.prm: Motion / ", entry, "fretval mdr"});
  };
  // The indenter would leave the surface.
  expect_refused("Normal force amplitude = 1", [](auto& motion) { motion.normal_force = {1, 1}; });
  expect_refused("three frequencies", [](auto& motion) {
    motion.tangential_frequency = std::sqrt(2.0);
    motion.tangential_harmonics = {{1e-6, std::sqrt(3.0), 0}};
  });
}

TEST(MdrCase, KnowsWhatHasAPeriod) {
  Case input = read_case();
  EXPECT_TRUE(mdr_case(input).has_period());
  input.motion.tangential_frequency = std::sqrt(2.0);
  EXPECT_FALSE(mdr_case(input).has_period());
  input.motion.tangential_frequency = input.motion.normal_frequency;
  input.motion.phase.reset();
  EXPECT_FALSE(mdr_case(input).has_period());
}

/// A parabola of 1 cm, G0 = 1 MPa, under F0 = 0.5 N, with a tangential force.
Case forced_case(double normal_amplitude, double tangential) {
  Case input = read_case();
  input.motion.normal_force = {0.5, normal_amplitude};
  input.motion.tangential_force = tangential;
  return input;
}

// Hertz under the largest force, of the relaxed body.
TEST(MdrCase, UnderANormalForceTheRelaxedBodyGoesDeepest) {
  const auto mdr = mdr_case(forced_case(0.1, 0.05));
  EXPECT_TRUE(mdr.normal_force && mdr.tangential_force);
  EXPECT_EQ(mdr.motion.indentation, 0.5);
  EXPECT_EQ(mdr.motion.normal.front().amplitude, 0.1);
  EXPECT_EQ(mdr.motion.tangential.front().amplitude, 0.05);
  EXPECT_NEAR(deepest_indentation(mdr) / std::pow(3 * 0.6 / (16 * 1e6 * std::sqrt(1e-2)), 2.0 / 3), 1, 1e-12);
}

// The radius of the profile is that to which the forces lead; it is not asked for.
TEST(MdrCase, LimitingProfileOfForcesIsThatOfTheirState) {
  Case input = forced_case(0, 0.05);
  input.wear = Case::Wear::limiting;
  const auto mdr = mdr_case(input);
  const double c = std::cbrt(3 * (0.5 - 0.05 / input.friction_coefficient) * 1e-2 / (16 * 1e6));
  EXPECT_NEAR(mdr.limiting->stick_radius / c, 1, 1e-9);
  EXPECT_NEAR(deepest_indentation(mdr) / mdr::maximum_indentation(mdr.limiting_state->motion), 1, 1e-12);
  input.motion.tangential_force = 1;
  expect_parts(refusal([&] { mdr_case(input); }), {"Wear / State = limiting", "no limiting state"});
  input.wear = Case::Wear::unworn;
  input.wear_kinetics = Case::WearKinetics{};
  input.wear_kinetics->coefficient = 1e-12;
  expect_parts(refusal([&] { mdr_case(input); }), {"Wear / Coefficient = 1e-12", "no limiting state"});
}

// What finite elements are given: a guess at the depth of forces, and the limiting profile with its amplitude, which is
// that of the case, whatever Poisson's ratio.
TEST(MdrCase, GivesFiniteElementsAGuessAndTheLimitingProfile) {
  const auto forced = mdr_case(forced_case(0.1, 0.05));
  EXPECT_EQ(expected_contact(forced).largest_indentation, deepest_indentation(forced));
  EXPECT_EQ(expected_contact(forced).carrying_radius, forced.limiting_state->stick_radius);
  EXPECT_FALSE(limiting_indenter(forced));
  auto input = limiting_case(0.6, 2e-6);
  input.elastomer.poisson_ratio = 0.3;
  const auto mdr = mdr_case(input);
  const auto limiting = limiting_indenter(mdr).value();
  EXPECT_EQ(limiting.stick_radius, mdr.limiting->stick_radius);
  const double between = (limiting.stick_radius + limiting.outer_radius) / 2;
  EXPECT_EQ(limiting.height(between), mdr::shape(*mdr.limiting, between));
  EXPECT_NEAR(limiting.tangential_amplitude * mdr.displacement / mdr.motion.tangential.front().amplitude, 1, 1e-15);
}

// Wear knows what forces of two frequencies lead to; a limiting profile is asked for by one.
TEST(MdrCase, ForcesOfTwoFrequenciesHaveALimitingStateForWear) {
  Case input = forced_case(0.1, 0.05);
  input.motion.tangential_frequency = 2 * input.motion.normal_frequency;
  const auto mdr = mdr_case(input);
  ASSERT_TRUE(mdr.limiting_state);
  EXPECT_GT(mdr.limiting_state->stick_radius, 0);
  EXPECT_LT(mdr.limiting_state->stick_radius, mdr_case(forced_case(0, 0)).limiting_state->stick_radius);
  input.wear = Case::Wear::limiting;
  EXPECT_EQ(mdr_case(input).limiting.value().stick_radius, mdr.limiting_state->stick_radius);
}

TEST(MdrCase, ShakedownAmplitudeNeedsAnIndentation) {
  Case input = forced_case(0.1, 0);
  input.motion.tangential_force.reset();
  input.motion.tangential_amplitude = std::nan("");
  expect_parts(refusal([&] { mdr_case(input); }), {"Tangential amplitude = shakedown", "Indentation"});
}

TEST(MdrCase, KnowsWhatATestRigPrescribes) {
  mdr::Prescribed prescribed{{2, {{0.5, 3, 0.1}}, {{0.25, 3, 0.4}}, true}, true, false};
  const auto control = control_of(prescribed);
  EXPECT_EQ(std::get<mdr::NormalForceControl>(control.normal).mean, 2);
  EXPECT_EQ(std::get<mdr::NormalForceControl>(control.normal).amplitude, 0.5);
  EXPECT_EQ(std::get<mdr::TangentialDisplacementControl>(control.tangential).amplitude, 0.25);
  EXPECT_DOUBLE_EQ(control.phase.value(), 0.3);
  prescribed.motion.phase_locked = false;
  EXPECT_FALSE(control_of(prescribed).phase);
}

TEST(MdrCase, NamesWhatNeedsOneHarmonicInEachDirection) {
  Case input = limiting_case(0.6, 2e-6);
  input.motion.normal_harmonics = {{1e-7, 2, 0}};
  expect_parts(refusal([&] { mdr_case(input); }),
               {"Tangential amplitude = shakedown", "one harmonic in each direction"});
}

/// 1.5 ± 0.3 N, 1.3 N, mu 0.8.
MdrCase case_of_forces(const std::string& phase) {
  auto text = replace(replace(elastic_case(), "Indentation = 1e-4", "Normal force = 1.5"), "Normal amplitude = 2e-5",
                      "Normal force amplitude = 0.3");
  text = replace(text, "Tangential amplitude = 1.5e-5", "Tangential force amplitude = 1.3");
  text = replace(replace(text, "Phase = 60", "Phase = " + phase), "Coefficient = 0.5", "Coefficient = 0.8");
  return mdr_case(read_case(text));
}

// |1.3 e^{i 45°} + 0.24| = 1.4795 N of 1.2 N.
TEST(GrossSlip, BeginsWhereTheForcesBalance) {
  EXPECT_NEAR(steady_sliding_share(case_of_forces("45")).value(), 0.8111, 1e-4);
  EXPECT_NEAR(steady_sliding_share(case_of_forces("135")).value(), 0.8111, 1e-4) << "half a cycle later it is the same";
  EXPECT_NEAR(steady_sliding_share(case_of_forces("0")).value(), 1.2 / 1.54, 1e-12);
  EXPECT_NEAR(steady_sliding_share(case_of_forces("90")).value(), 1.2 / std::hypot(1.3, 0.24), 1e-12);
  EXPECT_NEAR(steady_sliding_share(case_of_forces("free")).value(), 1.2 / 1.54, 1e-12) << "the worst phase comes";
}

// Whatever the instant: the largest demand over a period is what friction carries on average.
TEST(GrossSlip, LeavesNoInstantAboveFriction) {
  const double share = steady_sliding_share(case_of_forces("45")).value(), phase = std::acos(-1.0) / 4;
  double largest = 0;
  for (double t = 0; t < 2 * std::acos(-1.0); t += 1e-3)
    largest =
        std::max(largest, std::abs(share * 1.3 * std::cos(t + phase)) / (0.8 * (1.5 + share * 0.3 * std::cos(t))));
  EXPECT_NEAR(largest, 1, 1e-6);
}

TEST(GrossSlip, IsNoAlgebraOfDisplacements) {
  EXPECT_FALSE(steady_sliding_share(mdr_case(read_case(elastic_case()))));
}

}  // namespace
}  // namespace fretval::mdr_case_test
