#include "comparison/quantities/readings_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace fretval {
namespace {

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
}  // namespace fretval
