#include "comparison/verification/trade/trade.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

Quantities errors(double stick, double contact = 0, double force = 0) {
  return {{Quantity::stick_radius_first_slip, stick / 2},
          {Quantity::stick_radius_shakedown, stick},
          {Quantity::contact_radius_max, contact},
          {Quantity::normal_force_max, force}};
}

TradeLevel level(const Quantities& errors, double seconds, const std::string& kind = "condensed") {
  TradeLevel one{kind, nlohmann::ordered_json::object(), {}, errors};
  one.seconds = seconds;
  return one;
}

std::vector<std::size_t> front_of(const std::vector<std::pair<double, double>>& errors_and_seconds) {
  std::vector<TradeLevel> levels;
  for (const auto& [error, seconds] : errors_and_seconds)
    levels.push_back(level(std::isnan(error) ? Quantities{} : errors(error), seconds));
  return fretval::front_of(levels);
}

TEST(FrontOfLevels, KeepsWhatNoOtherLevelBeats) {
  EXPECT_EQ(front_of({{1e-2, 1}, {1e-3, 4}, {2e-3, 2}, {3e-3, 3}, {2e-3, 5}, {1e-4, 9}}),
            (std::vector<std::size_t>{0, 2, 1, 5}));
}

TEST(FrontOfLevels, TakesOneOfEqualLevelsAndNoneThatFailed) {
  EXPECT_EQ(front_of({{std::nan(""), 1}, {1e-2, 2}, {1e-2, 2}, {1e-2, 3}}), (std::vector<std::size_t>{1}));
  EXPECT_EQ(front_of({{1e-2, 1}, {1e-2 * (1 - 1e-12), 2}}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(front_of({{1e-2, 2}, {1e-3, 2}}), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(front_of({}).empty());
}

TEST(FrontOfLevels, IsOfTheCondensedOnes) {
  EXPECT_EQ(fretval::front_of({level(errors(0), 1e-5, "closed form"), level(errors(1e-3), 1)}),
            (std::vector<std::size_t>{1}));
}

// What the other settings leave behind must not flatten the slope of a sweep.
TEST(ObservedRate, LeavesOutTheFloorOfASweep) {
  std::vector<double> x, y;
  for (const double value : {8.0, 16.0, 32.0, 64.0, 128.0, 256.0}) {
    x.push_back(value);
    y.push_back(std::pow(value, -3) + 1e-6);
  }
  const auto rate = observed_rate(x, y);
  // Three floors up an error is up to 3/2 of its own: a slope over three doublings may be off by log2(3/2)/3.
  EXPECT_NEAR(rate->slope, -3, 0.2);
  EXPECT_EQ(rate->n_points, 4);
  EXPECT_GT(log_slope(x, y, 0)->slope, -2.5);
  // A fine point that is off by chance is behind the floor and does not count.
  EXPECT_NEAR(observed_rate({2, 4, 8, 16}, {1e-2, 1e-4, 2e-6, 4e-4})->slope, std::log2(1e-2), 1e-12);
  EXPECT_FALSE(observed_rate({}, {}));
}

TEST(Cheapest, IsTheFastestThatMeetsEveryTolerance) {
  const std::vector<TradeLevel> levels{level(errors(9e-4, 9e-5, 9e-5), 5),     level(errors(9e-4, 2e-4, 9e-5), 1),
                                       level(errors(9e-4, 9e-5, 2e-4), 1),     level(errors(2e-3, 9e-5, 9e-5), 1),
                                       level(errors(9.9e-4, 9e-5, 9.9e-5), 3), level({}, 0.5),
                                       level(errors(0), 1e-5, "closed form")};
  EXPECT_EQ(cheapest(levels, 1e-3), 4U);
  EXPECT_EQ(cheapest(levels, 1e-4), std::nullopt);
  EXPECT_FALSE(meets({}, 1));
}

TEST(TradeJson, HasTheAxesCoarsestFirstAndTheChoicesOfTheTool) {
  const auto prepared = prepared_case();
  TradeGrid grid{{8, 16, 32}, {3}, {}, {0.6, 0.3}, {25}, {96}, {}, {1e-2}};
  const auto plan = trade_plan(prepared.fem, grid);
  std::vector<TradeLevel> levels;
  for (const auto& [resolution, axes] : plan.settings) {
    levels.push_back(level(errors(std::pow(resolution.elements_per_radius, -2)), 1));
    levels.back().axes = axes;
  }
  const auto json = trade_json(prepared, plan, levels);
  EXPECT_EQ(json["axes"]["rings"]["values"], (nlohmann::ordered_json{8.0, 16.0, 32.0}));
  EXPECT_NEAR(json["axes"]["rings"]["power"].get<double>(), -2, 1e-12);
  EXPECT_EQ(json["axes"]["grading"]["values"], (nlohmann::ordered_json{0.6, 0.3}));
  EXPECT_TRUE(json["axes"]["order"]["power"].is_null());
  const auto& choice = json["recommendations"][0];
  EXPECT_EQ(levels[choice["chosen"].get<std::size_t>()].axes.size(), 0U);
  EXPECT_TRUE(choice["chosen_meets_tolerance"].get<bool>());
}

}  // namespace
}  // namespace fretval
