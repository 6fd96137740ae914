#include "comparison/accuracy/coarsening_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace fretval {
namespace {

constexpr const char* quantity = "stick_radius_shakedown";

const Resolution proved_resolution = resolution_for(1e-4);

/// 0.5, but for an error of third order in the rings and second in the steps.
Measures measured(const Resolution& r, double ring_error, double step_error) {
  return {{quantity,
           0.5 + ring_error * std::pow(r.elements_per_radius, -3) + step_error * std::pow(r.steps_per_cycle, -2)}};
}

struct Descent {
  Resolution cheapest;
  std::size_t n_computed;
};

Descent descent(const std::function<Measures(const Resolution&)>& compute, double bar,
                const FixedByCase& fixed = {false, false}) {
  const ProvedMeasures proved{{quantity, {0.5, bar, 1e-3}}};
  Economy economy({{proved_resolution, proved}}, {}, fixed);
  std::map<Resolution, Measures> known;
  for (auto wanted = economy.advance(known); !wanted.empty(); wanted = economy.advance(known))
    for (const auto& r : wanted) EXPECT_TRUE(known.emplace(r, compute(r)).second) << "computed twice";
  return {economy.tracks().front().resolution, known.size()};
}

TEST(Economy, EndsAtTheCoarsestThatTheProofCovers) {
  // 0.9e-3 is left of the tolerance: rings may be as few as (0.5/0.9e-3)^(1/3) = 8.2, steps as few as (1/0.9e-3)^(1/2)
  // = 33.
  const auto rings = descent([](const Resolution& r) { return measured(r, 0.5, 0); }, 1e-4);
  EXPECT_EQ(rings.cheapest.elements_per_radius, 9U);
  const auto steps = descent([](const Resolution& r) { return measured(r, 0, 1); }, 1e-4);
  EXPECT_EQ(steps.cheapest.steps_per_cycle, 36);
  EXPECT_EQ(steps.cheapest.elements_per_radius, 8U);
  EXPECT_EQ(steps.cheapest.degree, 2U);
  EXPECT_LE(steps.n_computed, 25U);
}

TEST(Economy, KeepsWhatTheProofDoesNotCover) {
  const auto compute = [](const Resolution& r) { return measured(r, 0.5, 1); };
  EXPECT_TRUE(descent(compute, 1.1e-3).cheapest == proved_resolution);
  EXPECT_TRUE(descent([](const Resolution&) { return Measures{}; }, 1e-4).cheapest == proved_resolution) << "failures";
}

TEST(Economy, KeepsWhatTheCaseFixes) {
  const auto exact = [](const Resolution& r) { return measured(r, 0, 0); };
  EXPECT_EQ(descent(exact, 1e-4, {true, false}).cheapest.elements_per_radius, proved_resolution.elements_per_radius);
  EXPECT_EQ(descent(exact, 1e-4, {false, true}).cheapest.steps_per_cycle, proved_resolution.steps_per_cycle);
}

TEST(Economy, TriesAgainWhatWasRefused) {
  // A lower degree alone is too much, and a nearer far field, which is tried after it, makes up for half of that.
  const auto compute = [](const Resolution& r) {
    const double degree = r.degree < 3 ? 1.2e-3 : 0, far_field = r.far_radius < 10 ? 1 : r.far_radius < 20 ? 6e-4 : 0;
    return Measures{{quantity, 0.5 + degree - far_field}};
  };
  EXPECT_EQ(descent(compute, 1e-4).cheapest.degree, 2U);
  EXPECT_NEAR(descent(compute, 1e-4).cheapest.far_radius, 12, 1e-9);
}

TEST(Economy, LeavesAloneWhatTheSceneDoesNotNeed) {
  const SceneNeeds elastic_and_locked{false, false};
  EXPECT_FALSE(coarsened(proved_resolution, Coarsening::half_the_start, elastic_and_locked));
  EXPECT_FALSE(coarsened(proved_resolution, Coarsening::half_the_creep, elastic_and_locked));
  EXPECT_TRUE(coarsened(proved_resolution, Coarsening::half_the_start, {true, false}));
}

TEST(Covers, AddsTheDistanceToTheBar) {
  const ProvedMeasures proved{{quantity, {0.5, 4e-4, 1e-3}}};
  EXPECT_TRUE(covers(proved, {{quantity, 0.5 + 5.9e-4}}));
  EXPECT_TRUE(covers(proved, {{quantity, 0.5 - 5.9e-4}}));
  EXPECT_FALSE(covers(proved, {{quantity, 0.5 + 6.1e-4}}));
  EXPECT_FALSE(covers(proved, {{quantity, std::nan("")}}));
  EXPECT_FALSE(covers(proved, {{"another", 0.5}}));
}

}  // namespace
}  // namespace fretval
