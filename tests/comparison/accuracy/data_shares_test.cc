#include "comparison/accuracy/data_shares.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/accuracy/verdict.h"
#include "comparison/case/path_table.h"
#include "tests/comparison/read_case.h"

namespace fretval::data_shares_test {
namespace {

TEST(DataShares, OfDataThatAreTakenAsTheyAreAreNone) {
  const auto input = read_case();
  EXPECT_TRUE(data_variants(input).empty());
  EXPECT_TRUE(data_uncertainties(input, mdr_case(input)).empty());
}

// Forces under prescribed displacements go with the modulus, radii do not.
TEST(DataShares, OfAHardnessAreThoseOfForces) {
  auto input = read_case(elastic_case());
  input.elastomer.modulus_scatter = 0.2;
  const auto open = data_uncertainties(input, mdr_case(input));
  EXPECT_NEAR(open.at(Quantity::normal_force_max), 0.2, 0.02);
  EXPECT_NEAR(open.at(Quantity::stick_radius_shakedown), 0, 1e-9);
}

/// A single pass over an elastic parabola, off by so much normally.
Case pass_with_error(double normal_error) {
  auto input = read_case(elastic_case());
  Case::Path path{"rig.csv", {0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false};
  path.reduction = Case::PathReduction{300'000, 0, normal_error, 0};
  input.motion = motion_along(path);
  return input;
}

// Of a parabola a = sqrt(R d): an error e of d is one of e/(2 d) of a.
TEST(DataShares, OfARecordAreWhatWasLeftOutOfIt) {
  const auto input = pass_with_error(1.2e-6);
  const auto open = data_uncertainties(input, mdr_case(input));
  EXPECT_NEAR(open.at(Quantity::contact_radius_max), 0.005, 2e-4);
  const auto twice = pass_with_error(2.4e-6);
  EXPECT_NEAR(data_uncertainties(twice, mdr_case(twice)).at(Quantity::contact_radius_max), 0.01, 3e-4);
}

TEST(DataShares, WidenTheBarButNotWhatTheComparisonDependsOn) {
  auto input = read_case(elastic_case());
  input.elastomer.modulus_scatter = 0.2;
  ErrorBudget budget;
  budget[Quantity::normal_force_max].add(ErrorSource::rings, 1e-3);
  add_data_shares(input, mdr_case(input), budget);
  const auto& bar = budget.at(Quantity::normal_force_max);
  EXPECT_NEAR(bar.total(), 0.2, 0.02);
  EXPECT_EQ(bar.of_numerics(), 1e-3);
  EXPECT_EQ(budget.size(), 1U);
  Difference one{1e-4, 2e-3};
  one.bar = bar;
  EXPECT_EQ(judged(one).verdict, Verdict::agree);
}

}  // namespace
}  // namespace fretval::data_shares_test
