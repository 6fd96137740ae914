#include "comparison/quantities/reading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/comparison/some_cycle.h"

namespace fretval::reading_test {
namespace {

const Scales some_scales{2, 3, 5};

TEST(Reading, DiffersOverTheScaleOfItsQuantity) {
  EXPECT_EQ(difference_of(Quantity::stick_radius_shakedown, {1.5}, {1}, some_scales), 0.25);
  EXPECT_EQ(difference_of(Quantity::normal_force_max, {5}, {4}, some_scales), 0.25);
  EXPECT_EQ(difference_of(Quantity::friction_work, {5}, {0}, some_scales), 1);
}

TEST(Reading, ThatOnlyOneHasIsADifferenceOfAllOfIt) {
  constexpr auto radius = Quantity::stick_radius_shakedown;
  EXPECT_FALSE(difference_of(radius, {1.5}, {{}}, some_scales));
  EXPECT_EQ(only_one_of(radius, {1.5}, {{}}, some_scales), 0.75);
  EXPECT_EQ(only_one_of(radius, {{}}, {1.5}, some_scales), -0.75);
  EXPECT_EQ(only_one_of(radius, {{}}, {{}}, some_scales), 0);
  EXPECT_EQ(only_one_of(radius, {1.5}, {1}, some_scales), 0);
}

TEST(Reading, IsUncertainOverItsScaleWhereItIsCompared) {
  const Readings readings{{Quantity::normal_force_max, {4, 1}},
                          {Quantity::stick_radius_shakedown, {{}, 1}},
                          {Quantity::axis_pressure_max, {4}},
                          {Quantity::friction_work, {4, 1, "", false}}};
  EXPECT_EQ(uncertainties_of(readings, some_scales),
            (Quantities{{Quantity::normal_force_max, 0.25}, {Quantity::stick_radius_shakedown, 0.5}}));
}

// Without memory friction takes all that is lost, and the other works say nothing more.
TEST(Reading, OfACycleHasWhatIsLostAltogether) {
  auto cycle = some_cycle({3, 0, 2, 1, 2.5});
  Readings readings;
  add_cycle(cycle, readings);
  EXPECT_EQ(readings.at(Quantity::cycle_work).value, 3);
  EXPECT_TRUE(readings.at(Quantity::tangential_work).is_compared);
  cycle.readings.at(Quantity::bulk_work).value = 0;
  add_cycle(cycle, readings);
  for (const auto& [quantity, reading] : readings)
    EXPECT_EQ(reading.is_compared, !traits_of(quantity).of_periodic_state) << name_of(quantity);
  EXPECT_EQ(cycle.value(Quantity::slip_decay), 0) << "it has none";
}

TEST(Reading, HasErrorsWhereBothHaveIt) {
  const auto a = Quantity::contact_radius_max, b = Quantity::normal_force_max, c = Quantity::stick_radius_shakedown;
  EXPECT_EQ(errors_of({{a, 1}, {b, 2}}, {{b, 5}, {c, 0}}), (Quantities{{b, 3}}));
  EXPECT_EQ(largest_of({{a, 1}, {b, 2}}), 2);
  EXPECT_TRUE(std::isnan(largest_of({})));
}

TEST(ReadingsJson, AreReadAsTheyWereWritten) {
  nlohmann::ordered_json json;
  add_readings({{Quantity::normal_force_max, {4, 1}},
                {Quantity::stick_radius_shakedown, {{}, {}, "nothing sticks"}},
                {Quantity::contact_radius_max, {2}}},
               json);
  EXPECT_EQ(json, nlohmann::ordered_json::parse(R"({"stick_radius_shakedown": null, "contact_radius_max": 2.0,
    "normal_force_max": 4.0, "uncertainty": {"normal_force_max": 1.0},
    "absent": {"stick_radius_shakedown": "nothing sticks"}})"));
  EXPECT_EQ(stored_reading(json, Quantity::normal_force_max)->uncertainty, 1);
  EXPECT_FALSE(stored_reading(json, Quantity::contact_radius_max)->uncertainty);
  EXPECT_EQ(stored_reading(json, Quantity::stick_radius_shakedown)->why_absent, "nothing sticks");
  EXPECT_FALSE(stored_reading(json, Quantity::friction_work));
}

}  // namespace
}  // namespace fretval::reading_test
