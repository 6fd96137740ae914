#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/comparison/made_up_result.h"

namespace fretval {
namespace {

// mu = 0.5. Pressures of the rings 4 3 2 5 and 1 0 0 2, tractions -1 -2 1 3 and 0.5 0 -0.5 0.
TEST(CycleJson, SaysWhereRingsStickSlipAndAreOpen) {
  auto result = made_up_result();
  result.input.wear = Case::Wear::limiting;  // without springs
  result.fem_case.friction_coefficient = 0.5;
  const auto json = cycle_json(result);
  EXPECT_EQ(json.at("zones"), nlohmann::ordered_json({"sf", "bo", "fo", "fs"}));
  EXPECT_EQ(json.at("r"), nlohmann::ordered_json({1.0, 3.0}));
  EXPECT_EQ(json.at("p")[0], nlohmann::ordered_json({10.0, 2.5}));
  EXPECT_EQ(json.at("tau")[3], nlohmann::ordered_json({7.5, 0.0}));
  EXPECT_EQ(json.at("t"), nlohmann::ordered_json({1.0, 2.0, 3.0, 4.0}));
  EXPECT_FALSE(json.contains("mdr"));
  EXPECT_FALSE(json.contains("slip_decay"));
  result.fe.fe.rings.stuck.shakedown = 1;
  result.fe.fe.friction.amplitude = 0.5;
  result.fe.fe.friction.slip_of_periods = {Eigen::Vector2d(0.25, 2), Eigen::Vector2d(0.125, 2)};
  EXPECT_EQ(cycle_json(result).at("zones"), nlohmann::ordered_json({"sf", "so", "so", "ss"})) << "it slips no more";
  EXPECT_EQ(cycle_json(result).at("slip_decay"), nlohmann::ordered_json({0.5, 0.25}));
}

}  // namespace
}  // namespace fretval
