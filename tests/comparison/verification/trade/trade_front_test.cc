#include "comparison/verification/trade/trade_front.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fretval {
namespace {

TEST(ParetoFront, KeepsWhatNoOtherPointBeats) {
  const std::vector<ErrorAndSeconds> points{{1e-2, 1}, {1e-3, 4}, {2e-3, 2}, {3e-3, 3}, {2e-3, 5}, {1e-4, 9}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{0, 2, 1, 5}));
}

TEST(ParetoFront, TakesOneOfEqualPointsAndNoneThatFailed) {
  const double none = std::nan("");
  EXPECT_EQ(pareto_front({{none, 1}, {1e-2, 2}, {1e-2, 2}, {1e-2, 3}, {1e-3, none}}), (std::vector<std::size_t>{1}));
  EXPECT_EQ(pareto_front({{1e-2, 1}, {1e-2 * (1 - 1e-12), 2}}), (std::vector<std::size_t>{0}));
  EXPECT_EQ(pareto_front({{1e-2, 2}, {1e-3, 2}}), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(pareto_front({}).empty());
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
}

TEST(Recommendation, PicksTheCheapestThatMeetsEveryTolerance) {
  const auto errors = [](double stick, double contact, double force) {
    return Quantities{{Quantity::stick_radius_first_slip, stick / 2},
                      {Quantity::stick_radius_shakedown, stick},
                      {Quantity::contact_radius_max, contact},
                      {Quantity::normal_force_max, force}};
  };
  const std::vector<Candidate> candidates{{errors(9e-4, 9e-5, 9e-5), 5},     {errors(9e-4, 2e-4, 9e-5), 1},
                                          {errors(9e-4, 9e-5, 2e-4), 1},     {errors(2e-3, 9e-5, 9e-5), 1},
                                          {errors(9.9e-4, 9e-5, 9.9e-5), 3}, {{}, 0.5}};
  EXPECT_EQ(cheapest(candidates, 1e-3), 4U);
  EXPECT_EQ(cheapest(candidates, 1e-4), std::nullopt);
  EXPECT_FALSE(meets({}, 1));
}

}  // namespace
}  // namespace fretval
