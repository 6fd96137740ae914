#include "comparison/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/read_case.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::scene_test {
namespace {

// The cycle of the finite elements begins at the largest indentation, and so does that of the reference.
TEST(Scene, TimeBeginsAtTheLargestIndentation) {
  Case input = read_case();
  input.motion.normal_harmonics = {{8e-6, 2, 110}};
  const auto motion = motion_of_case(input.motion);
  double depth = motion.indentation;
  for (const auto& harmonic : motion.normal) depth += harmonic.amplitude * std::cos(harmonic.phase);
  EXPECT_NEAR(depth / mdr::maximum_indentation(harmonic_motion_of(input.motion)), 1, 1e-12);
  EXPECT_EQ(motion_of_case(read_case().motion).tangential.front().phase, std::acos(-1.0) / 3);
}

// The amplitude that a case leaves to its limiting profile is none before the profile is known.
TEST(Scene, TakesTheAmplitudeOfTheLimitingIndenterWhereTheCaseLeavesItOpen) {
  Case::Motion motion = read_case().motion;
  const LimitingIndenter limiting{1e-4, 2e-4, [](double) { return 0.0; }, 3e-6};
  EXPECT_EQ(motion_of_case(motion, limiting).tangential.front().amplitude, motion.tangential_amplitude);
  motion.tangential_amplitude = std::nan("");
  EXPECT_EQ(motion_of_case(motion).tangential.front().amplitude, 0);
  EXPECT_EQ(motion_of_case(motion, limiting).tangential.front().amplitude, 3e-6);
}

TEST(Scene, TellsAProfileThatMdrDoesNotHoldFor) {
  const ScratchFolder folder;
  Case::Indenter indenter;
  indenter.shape = Case::Shape::table;
  indenter.table = folder.write("ridge.csv", "r [mm],f [um]\n0,0\n0.2,2\n0.4,2\n0.6,9\n").string();
  EXPECT_NE(falls_text(any_profile_of(indenter)), "");
  expect_parts(refusal([&] { profile_of(indenter); }), {"ridge.csv", "MDR does not hold", "g(x) falls for x"});
}

// A Prony body stands for the fractional one; the modulus over the frequencies of the motion is all that counts.
TEST(Scene, FractionalBodyHasItsModulusInTime) {
  Case input = read_case(replace(valid_case, "standard solid", "fractional zener\n  set Fractional order = 0.5"));
  input.motion.tangential_frequency = 50;
  const auto rheology = rheology_of(input.elastomer);
  const auto body = body_in_time(input);
  for (const double frequency : {1.0, 50.0}) {
    const double w = mdr::angular_frequency(frequency);
    EXPECT_NEAR(std::abs(mdr::complex_modulus(body, w) / mdr::complex_modulus(rheology, w) - 1.0), 0, 1e-4);
  }
}

// A slow harmonic along the surface counts as much as one of the indentation.
TEST(Scene, FractionalBodyHasItsModulusAtTheSlowestHarmonic) {
  Case input = read_case(replace(valid_case, "standard solid", "fractional zener\n  set Fractional order = 0.5"));
  const auto rheology = rheology_of(input.elastomer);
  const double slow = 1e-3, w = mdr::angular_frequency(slow);
  for (auto* harmonics : {&input.motion.normal_harmonics, &input.motion.tangential_harmonics}) {
    *harmonics = {{1e-6, slow, 0}};
    EXPECT_NEAR(std::abs(mdr::complex_modulus(body_in_time(input), w) / mdr::complex_modulus(rheology, w) - 1.0), 0,
                1e-4);
    harmonics->clear();
  }
}

TEST(Scene, HarmonicsAcrossHaveTheirPhaseInRadians) {
  Case input = read_case();
  input.motion.transverse = {{4e-6, 3, -45}};
  const auto along = harmonic_motion_of(input.motion).tangential;
  ASSERT_EQ(along.size(), 2U);
  EXPECT_FALSE(along[0].across);
  EXPECT_TRUE(along[1].across);
  EXPECT_EQ(along[1].amplitude, 4e-6);
  EXPECT_EQ(along[1].frequency, 3);
  EXPECT_NEAR(along[1].phase, -std::acos(-1.0) / 4, 1e-15);
}

// Degrees of the case file are radians of the reference, also of further harmonics.
TEST(Scene, HarmonicsHaveTheirNumbersInRadians) {
  Case input = read_case();
  input.motion.normal_harmonics = {{3e-6, 2, 90}};
  input.motion.tangential_harmonics = {{4e-6, 3, -45}};
  const auto motion = harmonic_motion_of(input.motion);
  const double pi = std::acos(-1.0);
  EXPECT_EQ(motion.indentation, 1e-4);
  const std::vector<mdr::Harmonic> normal{{2e-5, 1, 0}, {3e-6, 2, pi / 2}},
      tangential{{1.5e-5, 1, pi / 3}, {4e-6, 3, -pi / 4}};
  for (const auto& [found, wanted] : {std::pair(motion.normal, normal), {motion.tangential, tangential}}) {
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
      EXPECT_EQ(found[k].amplitude, wanted[k].amplitude);
      EXPECT_EQ(found[k].frequency, wanted[k].frequency);
      EXPECT_NEAR(found[k].phase, wanted[k].phase, 1e-15);
    }
  }
}

}  // namespace
}  // namespace fretval::scene_test
