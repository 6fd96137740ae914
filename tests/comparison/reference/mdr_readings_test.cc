#include "comparison/reference/mdr_readings.h"

#include <gtest/gtest.h>

#include "tests/comparison/some_cycle.h"

namespace fretval {
namespace {

const MdrAnswer some_answer{1.2, 2.5, std::nullopt, 1, std::nullopt, 4};

Readings readings_of_worn(MdrAnswer answer, std::optional<double> amplitude) {
  answer.of_kind = LimitingAnswer{amplitude};
  return compared_readings_of(answer);
}

TEST(MdrReadings, SayWhyThereIsNoValue) {
  const auto readings = readings_of(some_answer);
  EXPECT_EQ(readings.at(Quantity::stick_radius_shakedown).value, 1);
  EXPECT_FALSE(readings.at(Quantity::stick_radius_first_slip).value);
  EXPECT_EQ(readings.at(Quantity::stick_radius_first_slip).why_absent, "nothing sticks");
  auto pass = some_answer;
  pass.motion_kind = MotionKind::pass;
  pass.stick_radius_shakedown.reset();
  EXPECT_EQ(readings_of(pass).at(Quantity::stick_radius_shakedown).why_absent, "a single pass has no periodic state");
  EXPECT_FALSE(readings_of(pass).at(Quantity::stick_radius_shakedown).is_compared);
  pass.motion_kind = MotionKind::pass_from_touch;
  EXPECT_EQ(readings_of(pass).at(Quantity::stick_radius_first_slip).why_absent, nothing_at_rest);
  EXPECT_FALSE(readings_of(pass).at(Quantity::stick_radius_first_slip).is_compared);
  // Of an unworn indenter it is no amplitude of 0.
  EXPECT_FALSE(readings_of(some_answer).at(Quantity::limiting_amplitude).is_compared);
}

TEST(MdrReadings, OfAWornStateAreNoSlipNoForceAndTheWholeIndentation) {
  EXPECT_EQ(compared_readings_of(some_answer).count(Quantity::force_outside_stick_zone), 0U);
  const auto worn = readings_of_worn(some_answer, 0.9);
  EXPECT_EQ(worn.count(Quantity::slip_inside_stick_zone), 0U) << "the outer part of the contact slips";
  EXPECT_EQ(worn.at(Quantity::force_outside_stick_zone).value, 0);
  EXPECT_EQ(worn.at(Quantity::maximum_indentation).value, 1);
  EXPECT_EQ(worn.at(Quantity::limiting_amplitude).value, 0.9);
  const MdrAnswer all_sticks{1.2, 1, std::nullopt, 1, std::nullopt, 3};
  EXPECT_EQ(readings_of_worn(all_sticks, 1).at(Quantity::slip_inside_stick_zone).value, 0);
  const auto still = readings_of_worn(all_sticks, std::nullopt).at(Quantity::limiting_amplitude);
  EXPECT_FALSE(still.is_compared);
  EXPECT_EQ(still.why_absent, "nothing moves tangentially");
}

// Springs tell what they may be off by; without memory what friction takes is all that is lost.
TEST(MdrReadings, OfACycleHaveTheErrorsOfSprings) {
  auto answer = some_answer;
  answer.cycle = some_cycle({0.4, 0.1, 2e-6, 1e-6, 2e-6, 1e-3, 0, 0, 3e-8});
  auto readings = readings_of(answer);
  EXPECT_EQ(readings.at(Quantity::tangential_force_mean).uncertainty, 1e-3);
  EXPECT_EQ(readings.at(Quantity::tangential_work).uncertainty, 3e-8);
  EXPECT_EQ(readings.at(Quantity::cycle_work).value, 3e-6);
  EXPECT_TRUE(readings.at(Quantity::cycle_work).is_compared);
  const auto scales = scales_of(answer, 2);
  EXPECT_EQ(scales.contact_radius, 2);
  EXPECT_EQ(scales.sliding_force, 1);
  EXPECT_EQ(scales.sliding_work, 1e-4);
  answer.cycle->readings.at(Quantity::bulk_work).value = 0;
  EXPECT_FALSE(readings_of(answer).at(Quantity::cycle_work).is_compared);
}

TEST(MdrReadings, OfGrossSlipAreNotCompared) {
  auto answer = some_answer;
  answer.of_kind = GrossSlipShare{0.8};
  const auto readings = readings_of(answer);
  for (const auto& [quantity, reading] : readings) EXPECT_FALSE(reading.is_compared) << name_of(quantity);
  EXPECT_EQ(readings.at(Quantity::stick_radius_first_slip).why_absent, "the whole contact slides");
  EXPECT_EQ(readings.at(Quantity::normal_force_max).value, 4) << "the normal response stays";
}

}  // namespace
}  // namespace fretval
