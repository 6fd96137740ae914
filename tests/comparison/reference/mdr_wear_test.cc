#include "comparison/reference/mdr_wear.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/comparison/wearing_case.h"

namespace fretval {
namespace {

std::optional<mdr::WearKinetics> kinetics_of(const std::string& wear, const std::string& motion = "") {
  const auto prepared = wearing_case(wear, motion);
  return wear_kinetics_of(prepared.input, prepared.mdr, 1e4);
}

TEST(MdrWear, HasKineticsOfLawsThatAreLinearInThePressure) {
  const auto archard = kinetics_of("  set Coefficient = 1e-12\n");
  ASSERT_TRUE(archard);
  const auto energy = kinetics_of("  set Law = energy\n  set Coefficient = 2e-12\n");
  EXPECT_NEAR(energy->curve.back().volume / archard->curve.back().volume, 1, 1e-12);
  EXPECT_FALSE(kinetics_of("  set Law = power\n  set Exponent = 2\n  set Coefficient = 1e-12\n"));
}

TEST(MdrWear, HasKineticsOfLockedMotionsOfOneFrequency) {
  EXPECT_FALSE(kinetics_of("  set Coefficient = 1e-12\n", "set Phase = free"));
  EXPECT_FALSE(kinetics_of("  set Coefficient = 1e-12\n", "set Tangential frequency = 2"));
  EXPECT_FALSE(kinetics_of("  set Coefficient = 1e-12\n", "set Phase = 90\n  set Normal harmonics = 1e-6, 2, 0"));
}

TEST(MdrWear, LimitsBelongToEitherStickRadius) {
  const auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  MdrAnswer answer{};
  answer.stick_radius_shakedown = 6e-4;
  const auto limits = wear_limits(prepared.mdr, answer);
  EXPECT_EQ(limits.shakedown.stick_radius, 6e-4);
  EXPECT_NEAR(limits.shakedown.maximum_indentation, 1e-4, 1e-18);
  EXPECT_NEAR(limits.first_slip.stick_radius, 1e-9, 1e-13) << "nothing sticks";
  EXPECT_NEAR(limits.first_slip.outer_radius, std::sqrt(2) * 1e-3, 1e-7) << "f0 = d_max";
}

}  // namespace
}  // namespace fretval
