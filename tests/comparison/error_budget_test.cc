#include "comparison/error_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace fretval {
namespace {

constexpr double safety = 1.25;  // Roache, for an observed order

/// Values with an error of exactly factor * h^order at h = 1, 2 and 4.
Refinements power(double order, double factor = 1e-3) {
  return {0.5 + factor, 0.5 + factor * std::exp2(order), 0.5 + factor * std::exp2(2 * order)};
}

Resolution some_resolution() {
  return resolution_for(1e-3);
}

TEST(Richardson, IsExactOnPowers) {
  for (const double order : {1.0, 2.0, 3.0}) {
    const auto share = richardson(ErrorSource::rings, power(order), order);
    EXPECT_NEAR(share.estimate, safety * 1e-3, 1e-14);  // roundoff
    ASSERT_TRUE(share.order);
    EXPECT_NEAR(*share.order, order, 1e-10);
  }
}

TEST(Richardson, DoesNotTrustAnOrderAboveTheExpectedOne) {
  // Fourth order observed where third is expected: the error is taken for the larger one of third order.
  const auto share = richardson(ErrorSource::rings, power(4), 3);
  EXPECT_NEAR(share.estimate, safety * 1e-3 * (16 - 1) / (8 - 1), 1e-14);
}

TEST(Richardson, FallsBackWhenTheOrderIsNotCredible) {
  // An alternating sign, an order far too low, and one far too high: no observed order, and a larger safety factor.
  for (const auto& values : {Refinements{0.5, 0.501, 0.5005}, Refinements{0.5, 0.501, 0.5021}, power(7)}) {
    const auto share = richardson(ErrorSource::rings, values, 3);
    EXPECT_FALSE(share.order);
    EXPECT_GE(share.estimate, 3 * std::abs(values.fine - values.medium) / 7 * (1 - 1e-12));
    EXPECT_GE(share.estimate, 3 * std::abs(values.fine - *values.coarse) / 63 * (1 - 1e-12));
  }
}

TEST(Richardson, DoesWithoutTheCoarsestValue) {
  const auto share = richardson(ErrorSource::time_step, {0.5, 0.503, std::nullopt}, 2);
  EXPECT_NEAR(share.estimate, 3 * 0.003 / 3, 1e-14);
  EXPECT_FALSE(share.order);
}

TEST(ErrorBudget, SumsTheShares) {
  const ErrorBar bar{{{ErrorSource::rings, 1e-3, std::nullopt},
                      {ErrorSource::grading, 2e-3, std::nullopt},
                      {ErrorSource::edge, 4e-3, 3}}};
  EXPECT_DOUBLE_EQ(bar.total(), 7e-3);
  ASSERT_TRUE(bar.largest());
  EXPECT_EQ(bar.largest()->source, ErrorSource::edge);
  EXPECT_FALSE(ErrorBar{}.largest());
}

TEST(ErrorBudget, HasAShareForEverySourceAndTheEdge) {
  const Measures measures{{"stick_radius_shakedown", 0.5}};
  const auto variants = variants_of(some_resolution(), {true, true});
  const std::vector<Measures> varied(variants.size(), Measures{{"stick_radius_shakedown", 0.501}});
  const auto budget = error_budget(measures, variants, varied, 3, {{"stick_radius_shakedown", 1e-5}});
  const auto& shares = budget.at("stick_radius_shakedown").shares;
  // rings, element order, grading, far field, time step, start, creep, cycles, active set, edge
  EXPECT_EQ(shares.size(), 10U);
  for (const auto& share : shares) EXPECT_GT(share.estimate, 0) << name_of(share.source);
}

TEST(ErrorBudget, IsInfiniteWhereAQuantityIsMissing) {
  const Measures measures{{"stick_radius_shakedown", 0.5}};
  const auto variants = variants_of(some_resolution(), {});
  std::vector<Measures> varied(variants.size(), measures);
  varied.front() = {};  // a variant whose numerics failed
  const auto budget = error_budget(measures, variants, varied, 3, {});
  EXPECT_EQ(budget.at("stick_radius_shakedown").total(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace fretval
