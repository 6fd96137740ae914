#include "comparison/accuracy/fe_readings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/reference/mdr_readings.h"
#include "tests/comparison/some_cycle.h"

namespace fretval {
namespace {

const Units some_units{2, 0.5, 4, 1};  // a force of 4

TEST(FeReadings, InUnitsOfComparisonAreThoseOfTheSameMdr) {
  MdrAnswer mdr{1.2, 2.5, std::nullopt, 1, std::nullopt, 4 * std::exp(1.0)};
  FeAnswer fe;
  fe.contact_radius_max = 2.5;
  fe.stick_radius_shakedown = 1;
  fe.normal_force_max = 4 * std::exp(1.0);
  const auto by_mdr = [&](const Readings& readings) {
    auto quantities = compared_quantities(readings, scales_of(mdr, some_units.length), some_units);
    quantities.erase(Quantity::limiting_amplitude);
    return quantities;
  };
  auto quantities = quantities_of(fe, some_units);
  EXPECT_EQ(quantities, by_mdr(readings_of(mdr)));
  EXPECT_EQ(quantities.size(), 4U);
  EXPECT_EQ(quantities.at(Quantity::contact_radius_max), 1.25);
  EXPECT_EQ(quantities.at(Quantity::stick_radius_first_slip), 0);
  EXPECT_EQ(quantities.at(Quantity::stick_radius_shakedown), 0.5);
  EXPECT_NEAR(quantities.at(Quantity::normal_force_max), 1, 1e-15);
  fe.contact_radius_max.reset();
  fe.of_kind = NoWearEvidence{0, 0, 1, 1};
  mdr.contact_radius_max = 1;  // all of it sticks
  mdr.of_kind = LimitingAnswer{1};
  quantities = quantities_of(fe, some_units);
  EXPECT_EQ(quantities.at(Quantity::limiting_amplitude), 1);
  quantities.erase(Quantity::limiting_amplitude);
  auto worn = by_mdr(compared_readings_of(mdr));
  worn.erase(Quantity::contact_radius_max);
  EXPECT_EQ(quantities, worn);
}

TEST(FeReadings, LeaveOutRelativeValuesThatAreNotPositive) {
  const Scales scales{1, 1, 1};
  const auto known = [&](Quantity quantity, double value) {
    return compared_quantities({{quantity, {value}}}, scales, some_units).count(quantity) == 1;
  };
  EXPECT_TRUE(known(Quantity::tangential_work, 1e-9));
  EXPECT_FALSE(known(Quantity::tangential_work, 0));
  EXPECT_FALSE(known(Quantity::tangential_work, -1e-9));
  EXPECT_TRUE(known(Quantity::friction_work, -1e-9));           // over what sliding costs
  EXPECT_TRUE(known(Quantity::tangential_work, std::nan("")));  // is a failure, and must show
}

TEST(FeReadings, SayWhyThereIsNoValue) {
  FeAnswer fe;
  fe.stick_radius_shakedown = 1;
  auto readings = readings_of(fe, some_units);
  EXPECT_EQ(readings.at(Quantity::stick_radius_first_slip).why_absent, "nothing sticks");
  EXPECT_FALSE(readings.at(Quantity::contact_radius_max).is_compared);
  fe.motion_kind = MotionKind::pass;
  EXPECT_FALSE(readings_of(fe, some_units).at(Quantity::stick_radius_shakedown).is_compared);
  fe.motion_kind = MotionKind::pass_from_touch;
  EXPECT_EQ(readings_of(fe, some_units).at(Quantity::stick_radius_first_slip).why_absent, nothing_at_rest);
  EXPECT_FALSE(readings_of(fe, some_units).at(Quantity::stick_radius_first_slip).is_compared);
  fe.of_kind = GrossSlipStart{1, 0.5};
  readings = readings_of(fe, some_units);
  EXPECT_EQ(readings.at(Quantity::normal_force_max).why_absent, "the whole contact slides");
  for (const auto& [quantity, reading] : readings) EXPECT_FALSE(reading.is_compared) << name_of(quantity);
}

TEST(FeReadings, OfACycleHaveWhatReadingTheEdgesLeavesOpen) {
  FeAnswer fe;
  fe.cycle = some_cycle({0.4, 0.1, 2e-6, 1e-6, 2e-6, 0.01, 1e-8, 2e-8, 4e-8});
  const auto readings = readings_of(fe, some_units);
  EXPECT_EQ(readings.at(Quantity::cycle_work).value, 3e-6);
  EXPECT_NEAR(readings.at(Quantity::bulk_work).uncertainty.value(), 3e-8, 1e-20);
  const auto uncertainties = uncertainties_of(readings, scales_of(fe, some_units));
  EXPECT_EQ(uncertainties.at(Quantity::tangential_force_mean), 0.01);
  EXPECT_NEAR(uncertainties.at(Quantity::tangential_work), 0.02, 1e-15);
  EXPECT_EQ(uncertainties.count(Quantity::axis_pressure_max), 0U);
}

// Their unit of length is no contact radius, and what sticks may be annuli.
TEST(FeReadings, OfZonesAreRelative) {
  FeAnswer fe;
  fe.contact_radius_max = 2 * std::exp(1.0);
  fe.normal_force_max = 4;
  fe.of_kind = ZoneAnswer{};
  const auto quantities = quantities_of(fe, some_units);
  EXPECT_NEAR(quantities.at(Quantity::contact_radius_max), 1, 1e-15);
  EXPECT_EQ(quantities.count(Quantity::stick_radius_shakedown), 0U);
}

}  // namespace
}  // namespace fretval
