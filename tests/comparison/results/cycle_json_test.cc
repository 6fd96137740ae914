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
}

}  // namespace
}  // namespace fretval
