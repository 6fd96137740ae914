#include "comparison/accuracy/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/reference/mdr_readings.h"

namespace fretval {
namespace {

constexpr double a = 1e-3;

MdrAnswer mdr_with(std::optional<double> stick) {
  return {1.5, a, stick, stick, std::nullopt, 2.0};
}

FeAnswer fe_with(std::optional<double> stick) {
  FeAnswer fe{};
  fe.contact_radius_max = a;
  fe.stick_radius_first_slip = stick;
  fe.stick_radius_shakedown = stick;
  fe.normal_force_max = 2.0;
  return fe;
}

/// The readings of both, of a profile in which nothing wears if finite elements have evidence of that.
Comparison compare(const MdrAnswer& mdr, const FeAnswer& fe, double contact_radius, const Tolerances& tolerances,
                   const ErrorBudget& budget = {}) {
  const Units units{contact_radius, 1, 1, 1};
  return compare(readings_of(fe, units), fe.no_wear ? readings_of_worn(mdr) : readings_of(mdr),
                 scales_of(mdr, contact_radius), tolerances, budget);
}

bool agree(std::optional<double> mdr, std::optional<double> fe) {
  return passes(compare(mdr_with(mdr), fe_with(fe), a, tolerances_of(1e-3)));
}

TEST(Comparison, ComparesStickRadiiOverTheContactRadius) {
  EXPECT_TRUE(agree(0.5 * a, 0.5009 * a));
  EXPECT_FALSE(agree(0.5 * a, 0.5011 * a));
  EXPECT_FALSE(agree(0.5 * a, 0.4989 * a));
}

TEST(Comparison, HoldsSmallStickZonesToTheSameTolerance) {
  EXPECT_TRUE(agree(0.05 * a, 0.0509 * a));
  EXPECT_FALSE(agree(0.05 * a, 0.0511 * a));
}

TEST(Comparison, DemandsThatBothSayThatNothingSticks) {
  EXPECT_TRUE(agree(std::nullopt, std::nullopt));
  EXPECT_FALSE(agree(std::nullopt, 0.01 * a));
  EXPECT_FALSE(agree(0.1 * a, std::nullopt));
}

TEST(Comparison, HoldsRadiusAndForceToATenth) {
  auto fe = fe_with(0.5 * a);
  fe.contact_radius_max = a * (1 + 1.1e-4);
  EXPECT_FALSE(passes(compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3))));
  fe = fe_with(0.5 * a);
  fe.normal_force_max = 2.0 * (1 - 1.1e-4);
  EXPECT_FALSE(passes(compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3))));
}

// Finite elements less MDR: radii over a, which is 2, the force relatively, slip and force outside c as they are.
TEST(Comparison, HasEveryDifferenceWithItsSignAndTolerance) {
  FeAnswer fe = fe_with(0.5 * a);
  fe.stick_radius_shakedown = 0.25 * a;
  fe.contact_radius_max = 1.25 * a;
  fe.normal_force_max = 1;
  fe.no_wear = NoWearEvidence{0.125, 0.0625, 0.75, 1.5};
  MdrAnswer mdr = mdr_with(a);
  mdr.stick_radius_first_slip = 0.375 * a;
  mdr.limiting_amplitude = 1.25;
  const std::map<Quantity, std::pair<double, double>> wanted{
      {Quantity::contact_radius_max, {0.125, 1e-4}},       {Quantity::normal_force_max, {-0.5, 1e-4}},
      {Quantity::stick_radius_first_slip, {0.0625, 1e-3}}, {Quantity::stick_radius_shakedown, {-0.375, 1e-3}},
      {Quantity::slip_inside_stick_zone, {0.125, 1e-3}},   {Quantity::force_outside_stick_zone, {0.0625, 1e-3}},
      {Quantity::maximum_indentation, {-0.25, 1e-3}},      {Quantity::limiting_amplitude, {0.25, 1e-3}}};
  const auto found = compare(mdr, fe, 2 * a, tolerances_of(1e-3));
  ASSERT_EQ(found.size(), wanted.size());
  for (const auto& [quantity, one] : wanted) {
    EXPECT_NEAR(found.at(quantity).difference.value(), one.first, 1e-12) << name_of(quantity);
    EXPECT_NEAR(found.at(quantity).tolerance, one.second, 1e-15) << name_of(quantity);
  }
}

TEST(Comparison, FailsOnNotANumber) {
  EXPECT_FALSE(agree(0.5 * a, std::nan("")));
}

TEST(Comparison, HoldsTheLimitingStateToNoSlipAndNoPressure) {
  auto fe = fe_with(0.5 * a);
  fe.contact_radius_max.reset();
  fe.no_wear = NoWearEvidence{1e-5, 1e-5, 1, 1};
  MdrAnswer mdr = mdr_with(0.5 * a);
  mdr.contact_radius_max = 0.5 * a;  // all of the contact sticks
  mdr.limiting_amplitude = 1;
  const auto judge = [&] { return passes(compare(mdr, fe, a, tolerances_of(1e-3))); };
  EXPECT_TRUE(judge());
  fe.no_wear = NoWearEvidence{2e-3, 1e-5, 1, 1};
  EXPECT_FALSE(judge());
  mdr.contact_radius_max = 0.6 * a;  // its outer part slips, says MDR as well
  EXPECT_TRUE(judge());
  fe.no_wear = NoWearEvidence{1e-5, 2e-3, 1, 1};
  EXPECT_FALSE(judge());
  fe.no_wear = NoWearEvidence{1e-5, 1e-5, 1.002, 1};
  EXPECT_FALSE(judge());
  fe.no_wear = NoWearEvidence{1e-5, 1e-5, 1, 0.998};
  EXPECT_FALSE(judge());
}

Verdict verdict_with(double difference, double bar) {
  const ErrorBudget budget{{Quantity::stick_radius_shakedown, {{{ErrorSource::rings, bar, std::nullopt}}}}};
  const auto verdict = compare(mdr_with(0.5 * a), fe_with((0.5 + difference) * a), a, tolerances_of(1e-3), budget);
  return verdict.at(Quantity::stick_radius_shakedown).verdict;
}

TEST(Comparison, IsInconclusiveWhereTheErrorBarIsTooWide) {
  EXPECT_EQ(verdict_with(5e-4, 9e-4), Verdict::pass);
  EXPECT_EQ(verdict_with(2e-3, 9e-4), Verdict::fail);
  EXPECT_EQ(verdict_with(5e-4, 2e-3), Verdict::inconclusive);
  EXPECT_EQ(verdict_with(2e-3, 2e-3), Verdict::inconclusive);
  // So far off that the bar does not matter.
  EXPECT_EQ(verdict_with(4e-3, 2e-3), Verdict::fail);
  EXPECT_EQ(verdict_with(5e-4, std::numeric_limits<double>::infinity()), Verdict::inconclusive);
}

// A zone that only one of the two finds is a difference of all of it, whatever the bar makes of the rest.
TEST(Comparison, DisagreesWhereOnlyOneSticksBeyondTheBar) {
  const auto verdict = [](std::optional<double> mdr, std::optional<double> fe, double bar) {
    const ErrorBudget budget{{Quantity::stick_radius_shakedown, {{{ErrorSource::rings, bar, std::nullopt}}}}};
    return compare(mdr_with(mdr), fe_with(fe), a, tolerances_of(1e-3), budget)
        .at(Quantity::stick_radius_shakedown)
        .verdict;
  };
  EXPECT_EQ(verdict(0.5 * a, std::nullopt, 2e-3), Verdict::fail);
  EXPECT_EQ(verdict(std::nullopt, 0.5 * a, 2e-3), Verdict::fail);
  EXPECT_EQ(verdict(1e-3 * a, std::nullopt, 2e-3), Verdict::inconclusive);
  EXPECT_EQ(verdict(std::nullopt, std::nullopt, 2e-3), Verdict::inconclusive);
  EXPECT_EQ(verdict(std::nullopt, std::nullopt, 5e-4), Verdict::pass);
}

TEST(Comparison, AnInconclusiveComparisonDoesNotPass) {
  const ErrorBudget budget{{Quantity::normal_force_max, {{{ErrorSource::rings, 1e-3, std::nullopt}}}}};
  const auto verdict = compare(mdr_with(0.5 * a), fe_with(0.5 * a), a, tolerances_of(1e-3), budget);
  EXPECT_FALSE(passes(verdict));
  EXPECT_FALSE(verdict.at(Quantity::stick_radius_shakedown).bar);
  ASSERT_TRUE(verdict.at(Quantity::normal_force_max).bar);
  EXPECT_EQ(verdict.at(Quantity::normal_force_max).bar->total(), 1e-3);
}

TEST(Comparison, OfACycleIsOverWhatSlidingWouldCost) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycle = MdrCycle{0.4, 0.1, 2e-6, 1e-6, 2e-6, 1, 1e-4, 0, 0, 0};
  fe.cycle = fem::CycleResponse{0.4002, 0.1005, 2.05e-6, 0.951e-6, 2.002e-6, 1, 1e-4};
  mdr.slip_decay = 0.5;
  fe.slip_decay = fem::DecayFactor{0.501, 0};
  const auto comparison = compare(mdr, fe, a, tolerances_of(1e-3));
  EXPECT_NEAR(*comparison.at(Quantity::tangential_force_max).difference, 5e-4, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::tangential_force_mean).difference, 5e-4, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::friction_work).difference, 5e-4, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::cycle_work).difference, 1e-3 / 3, 1e-12);
  EXPECT_FALSE(comparison.at(Quantity::friction_work).passes());  // a tenth of what a radius is asked for
  EXPECT_NEAR(*comparison.at(Quantity::bulk_work).difference, -0.049, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::tangential_work).difference, 1e-3, 1e-12);
}

TEST(Comparison, OfTheDecayOfSlipNeedsABar) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.slip_decay = 0.5;
  fe.slip_decay = fem::DecayFactor{0.501, 0};
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).count(Quantity::slip_decay), 0U);
  const ErrorBudget budget{{Quantity::slip_decay, {{{ErrorSource::time_step, 5e-3, std::nullopt}}}}};
  const auto compared = compare(mdr, fe, a, tolerances_of(1e-3), budget).at(Quantity::slip_decay);
  EXPECT_NEAR(*compared.difference, 2e-3, 1e-12);
  EXPECT_TRUE(compared.passes());
}

// The springs' own error is allowed on top of the bar.
TEST(Comparison, OfTheCyclesToShakedownIsRelativeAndNeedsABar) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycles_to_shakedown = SettlingCycles{10, 0.02};
  fe.cycles_to_shakedown = 10.06;
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).count(Quantity::cycles_to_shakedown), 0U);
  for (const double bar : {5e-3, 3e-3}) {
    const ErrorBudget budget{{Quantity::cycles_to_shakedown, {{{ErrorSource::rings, bar, std::nullopt}}}}};
    const auto compared = compare(mdr, fe, a, tolerances_of(1e-3), budget).at(Quantity::cycles_to_shakedown);
    EXPECT_NEAR(*compared.difference, 6e-3, 1e-12);
    EXPECT_NEAR(compared.tolerance, bar + 2e-3, 1e-12);
    EXPECT_EQ(compared.passes(), bar == 5e-3);
  }
}

// The springs' own error is allowed on top; without a value of either there is nothing to compare.
TEST(Comparison, OfThePressureOnTheAxisIsRelative) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  fe.axis_pressure_max = 1.0025e5;
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).count(Quantity::axis_pressure_max), 0U);
  mdr.axis_pressure = mdr::AxisPressure{1e5, 0};
  const auto compared = compare(mdr, fe, a, tolerances_of(1e-3)).at(Quantity::axis_pressure_max);
  EXPECT_NEAR(*compared.difference, 2.5e-3, 1e-12);
  EXPECT_FALSE(compared.passes());
  mdr.axis_pressure->error = 200;
  EXPECT_TRUE(compare(mdr, fe, a, tolerances_of(1e-3)).at(Quantity::axis_pressure_max).passes());
}

// What comes along is held to its bar where that is wider than its tolerance, and left out where there is none.
TEST(Comparison, HoldsWhatComesAlongToItsBar) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycle = MdrCycle{0.4, 0, 2e-6, 0, 2e-6, 1, 1e-4, 0, 0, 0};
  fe.cycle = fem::CycleResponse{0.402, 0, 2e-6, 0, 2e-6, 1, 1e-4};
  const auto with_bar = [&](double width) {
    const ErrorBudget budget{{Quantity::tangential_force_max, {{{ErrorSource::rings, width, std::nullopt}}}}};
    return compare(mdr, fe, a, tolerances_of(1e-3), budget);
  };
  EXPECT_TRUE(passes(with_bar(6e-3)));
  EXPECT_FALSE(passes(with_bar(4e-3)));
  EXPECT_EQ(with_bar(6e-3).at(Quantity::tangential_force_max).tolerance, 6e-3);
  EXPECT_EQ(with_bar(std::numeric_limits<double>::infinity()).count(Quantity::tangential_force_max), 0U);
}

TEST(Comparison, OfALargestForceNeedsSpringsThatKnowIt) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycle = MdrCycle{0.4, 0, 2e-6, 0, 2e-6, 1, 1e-4, 0, 0, 0, false};
  fe.cycle = fem::CycleResponse{0.402, 0, 2e-6, 0, 2e-6, 1, 1e-4};
  const auto without = compare(mdr, fe, a, tolerances_of(1e-3));
  EXPECT_EQ(without.count(Quantity::tangential_force_max), 0U);
  EXPECT_EQ(without.count(Quantity::tangential_force_mean), 1U);
  mdr.cycle->knows_largest_force = true;
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).at(Quantity::tangential_force_max).verdict, Verdict::fail);
}

// With a tolerance of its own it has to meet that, a tenth of it for friction over sliding, and the error of the
// springs.
TEST(Comparison, HoldsACycleToItsTolerance) {
  const auto tolerances = tolerances_of(1e-3, 5e-3);
  EXPECT_EQ(tolerance_of(tolerances, Quantity::tangential_work), 5e-3);
  EXPECT_EQ(tolerance_of(tolerances, Quantity::friction_work), 5e-4);
  EXPECT_EQ(tolerance_of(tolerances, Quantity::cycles_to_shakedown), 1e-3);
  EXPECT_TRUE(is_refined_for(Quantity::tangential_force_max, tolerances));
  EXPECT_FALSE(is_refined_for(Quantity::tangential_force_max, tolerances_of(1e-3)));
  EXPECT_FALSE(is_refined_for(Quantity::slip_decay, tolerances));
  EXPECT_TRUE(is_refined_for(Quantity::stick_radius_shakedown, tolerances_of(1e-3)));

  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycle = MdrCycle{0.4, 0, 2e-6, 0, 2e-6, 1, 1e-4, 4e-4, 0, 0};
  fe.cycle = fem::CycleResponse{0.402, 0, 2e-6, 0, 2e-6, 1, 1e-4};
  const auto with_bar = [&](double width) {
    const ErrorBudget budget{{Quantity::tangential_force_max, {{{ErrorSource::rings, width, std::nullopt}}}}};
    return compare(mdr, fe, a, tolerances, budget).at(Quantity::tangential_force_max);
  };
  EXPECT_NEAR(with_bar(4e-3).tolerance, 6e-3, 1e-15);
  EXPECT_TRUE(with_bar(4e-3).passes());
  EXPECT_EQ(with_bar(7e-3).verdict, Verdict::inconclusive);
}

}  // namespace
}  // namespace fretval
