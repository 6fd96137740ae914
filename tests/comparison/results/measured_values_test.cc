#include "comparison/results/measured_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

using nlohmann::ordered_json;

TEST(MeasuredValues, StandBesideBothMethods) {
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->stick_radius = Case::Measured::Value{0.8e-3, 2e-5};
  const ordered_json fe{{"stick_radius_shakedown", 0.79e-3}}, mdr{{"stick_radius_shakedown", nullptr}};
  const auto json = measured_json(input, fe, mdr);
  const auto& radius = json.at("stick_radius_shakedown");
  EXPECT_EQ(radius.at("value"), 0.8e-3);
  EXPECT_EQ(radius.at("uncertainty"), 2e-5);
  EXPECT_NEAR(radius.at("fe_difference").get<double>(), -1e-5, 1e-18);
  EXPECT_TRUE(radius.at("mdr").is_null() && radius.at("mdr_difference").is_null());
  EXPECT_TRUE(measured_json(read_case(), fe, mdr).is_null());
}

// The area of an ellipse of half axes 2e-6 m and 3 N.
TEST(MeasuredValues, ComeOutOfLoops) {
  auto input = read_case();
  input.measured = Case::Measured{};
  auto& measured = *input.measured;
  constexpr int n = 720;
  for (int i = 0; i < n; ++i) {
    const double phase = 2 * M_PI * i / n;
    measured.tangential_displacement.push_back(2e-6 * std::cos(phase));
    measured.tangential_force.push_back(3 * std::sin(phase) - 0.5);
    measured.normal_force.push_back(5 + std::cos(phase));
  }
  const auto json = measured_json(input, {{"normal_force_max", 6.5}}, ordered_json::object());
  EXPECT_NEAR(json.at("tangential_work").at("value").get<double>() / (M_PI * 6e-6), 1, 1e-4);
  EXPECT_NEAR(json.at("tangential_force_max").at("value").get<double>(), 3.5, 1e-4);
  EXPECT_NEAR(json.at("normal_force_max").at("fe_difference").get<double>(), 0.5, 1e-12);
}

}  // namespace
}  // namespace fretval
