#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "comparison/data/path_table.h"
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

// In a pass no ring settles: those that have never slipped are told by their number. Of annuli none is told by it.
TEST(CycleJson, OfAPassAndOfAnnuliSaysWhatRingsDo) {
  auto result = made_up_result();
  result.input.wear = Case::Wear::limiting;  // without springs
  result.fem_case.friction_coefficient = 0.5;
  auto& fe = result.fe.fe;
  fe.rings.stuck.first_slip = 1;
  fe.friction.amplitude = 0.5;
  fe.friction.slip_of_periods = {Eigen::Vector2d(0.25, 2)};
  fe.motion_kind = MotionKind::pass;
  EXPECT_EQ(cycle_json(result).at("zones"), nlohmann::ordered_json({"sf", "so", "so", "ss"}));
  EXPECT_FALSE(cycle_json(result).contains("slip_decay"));
  fe.motion_kind = MotionKind::cycles;
  EXPECT_EQ(cycle_json(result).at("zones"), nlohmann::ordered_json({"sf", "bo", "fo", "fs"}));
  fe.rings.stuck.shakedown = 1;
  fe.of_kind = ZoneAnswer{};
  EXPECT_EQ(cycle_json(result).at("zones"), nlohmann::ordered_json({"sf", "bo", "fo", "fs"}));
}

// Of 50 steps every other one is shown, up to the last, whose pressure is 49 times 2.5 Pa; of zones all of them.
TEST(CycleJson, ShowsTheEndOfAPeriodOfManySteps) {
  constexpr int n = 50;
  auto result = made_up_result();
  result.input.wear = Case::Wear::limiting;  // without springs
  auto& fe = result.fe.fe;
  fe.normal.steps_per_cycle = n;
  fe.friction.n_steps = 3 * n;
  fe.friction.traction = Eigen::MatrixXd::Zero(2, n);
  fe.normal.pressure = Eigen::VectorXd::LinSpaced(n, 0, n - 1).transpose().replicate(2, 1);
  const auto json = cycle_json(result);
  ASSERT_EQ(json.at("t").size(), 25U);
  EXPECT_EQ(json.at("t").front(), 0.16) << "the end of the second step of 0.08 s";
  EXPECT_EQ(json.at("t").back(), 4.0);
  EXPECT_EQ(json.at("p").front(), nlohmann::ordered_json({2.5, 2.5}));
  EXPECT_EQ(json.at("p").back(), nlohmann::ordered_json({122.5, 122.5}));
  ASSERT_EQ(json.at("zones").size(), 50U);
  EXPECT_EQ(json.at("zones").front(), "oo");
}

// Steps of a path end where its pieces do, and are not equal: a cycle of 2 pi takes 4 s.
TEST(CycleJson, HasTheTimesAtWhichTheStepsOfAPathEnd) {
  auto result = made_up_result();
  result.input.wear = Case::Wear::limiting;  // without springs
  const double part = 2 * std::acos(-1.0) / 8;
  auto& pieces = result.fe.fe.normal.pieces;
  pieces.resize(4);
  double begin = 0;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    pieces[k].begin = begin;
    pieces[k].end = begin += part * (k < 2 ? 1 : 3);
  }
  const auto t = cycle_json(result).at("t").get<std::vector<double>>();
  ASSERT_EQ(t.size(), 48U) << "at equal times, those of the steps that hold them";
  EXPECT_EQ(std::vector<double>(t.begin(), t.begin() + 7), (std::vector<double>{0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 1}));
  EXPECT_EQ(t[12], 2.5);
  EXPECT_EQ(t.back(), 4.0);
}

/// Hertz on the axis: 8 G sqrt(d/R)/pi.
double pressure_on_axis(double depth) {
  return 8 * 1e6 * std::sqrt(depth / 1e-2) / std::acos(-1.0);
}

/// Largest difference of the pressures of springs from those of Hertz.
double off_hertz(const nlohmann::ordered_json& springs, double depth) {
  double worst = 0;
  for (std::size_t k = 0; k < springs.at("r").size(); ++k) {
    const double r = springs.at("r")[k], p = springs.at("p")[k];
    const double inside = std::max(0.0, 1 - r * r / (1e-2 * depth));
    worst = std::max(worst, std::abs(p - pressure_on_axis(depth) * std::sqrt(inside)));
  }
  return worst / pressure_on_axis(depth);
}

// An elastic parabola of R = 1e-2 m and G = 1 MPa that goes down to 1.2e-4 m: F_N = 16/3 G sqrt(R) d^(3/2).
TEST(CycleJson, HasTheSpringsOfAnOscillationAtItsDeepest) {
  auto result = made_up_result();
  const auto prepared = prepared_case(elastic_case());
  result.input = prepared.input;
  result.mdr_case = prepared.mdr;
  const auto springs = cycle_json(result).at("mdr");
  EXPECT_LT(off_hertz(springs, 1.2e-4), 0.02);
  const auto largest = [&](const char* key) {
    const auto values = springs.at(key).get<std::vector<double>>();
    return *std::max_element(values.begin(), values.end());
  };
  EXPECT_NEAR(largest("F_N") / (16.0 / 3 * 1e6 * 0.1 * std::pow(1.2e-4, 1.5)), 1, 1e-3);
  EXPECT_NEAR(largest("d"), 1.2e-4, 1e-9);
  EXPECT_NEAR(largest("u_x"), 1.5e-5, 1e-8);
  EXPECT_LT(largest("F_x"), 0.5 * largest("F_N"));
  result.input.sweep = Case::Sweep{"family", "Motion / Phase", 60};
  EXPECT_FALSE(cycle_json(result).contains("mdr")) << "a sweep has a line of its own";
  result.input.sweep.reset();
  result.input.wear = Case::Wear::limiting;
  EXPECT_FALSE(cycle_json(result).contains("mdr")) << "springs are not worn";
}

// A path that ends at 1e-4 m after 1.2e-4 m.
TEST(CycleJson, HasTheSpringsOfAPathAtItsEnd) {
  auto result = made_up_result();
  const auto prepared = prepared_case(elastic_case());
  result.input = prepared.input;
  result.mdr_case = prepared.mdr;
  const Case::Path path{{{0, 1, 2}, {1e-4, 1.2e-4, 1e-4}, {0, 8e-6, 0}, true}, "a.csv"};
  result.input.motion = motion_along(path);
  result.mdr_case.path = mdr::SampledPath{path.time, path.normal, path.tangential, path.repeats};
  EXPECT_LT(off_hertz(cycle_json(result).at("mdr"), 1e-4), 0.02);
}

}  // namespace
}  // namespace fretval
