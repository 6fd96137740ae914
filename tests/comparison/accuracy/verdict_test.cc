#include "comparison/accuracy/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/case/case.h"
#include "comparison/reference/mdr_readings.h"
#include "tests/comparison/some_cycle.h"

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
  return compare(readings_of(fe, units), compared_readings_of(mdr), scales_of(mdr, contact_radius), tolerances, budget);
}

/// Bars of all that finite elements have, but for the widest.
ErrorBudget bars_of(const FeAnswer& fe, double width = 1e-6) {
  ErrorBudget budget;
  for (const auto& [quantity, reading] : readings_of(fe, {a, 1, 1, 1}))
    if (reading.is_compared) budget[quantity].add(ErrorSource::rings, width);
  return budget;
}

Outcome outcome_with(const MdrAnswer& mdr, const FeAnswer& fe) {
  return outcome_of(compare(mdr, fe, a, tolerances_of(1e-3), bars_of(fe)));
}

bool agree(std::optional<double> mdr, std::optional<double> fe) {
  return outcome_with(mdr_with(mdr), fe_with(fe)) == Outcome::agree;
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
  EXPECT_EQ(outcome_with(mdr_with(0.5 * a), fe), Outcome::disagree);
  fe = fe_with(0.5 * a);
  fe.normal_force_max = 2.0 * (1 - 1.1e-4);
  EXPECT_EQ(outcome_with(mdr_with(0.5 * a), fe), Outcome::disagree);
}

// Finite elements less MDR: radii over a, which is 2, the force relatively, slip and force outside c as they are.
TEST(Comparison, HasEveryDifferenceWithItsSignAndTolerance) {
  FeAnswer fe = fe_with(0.5 * a);
  fe.stick_radius_shakedown = 0.25 * a;
  fe.contact_radius_max = 1.25 * a;
  fe.normal_force_max = 1;
  fe.of_kind = NoWearEvidence{0.125, 0.0625, 0.75, 1.5};
  MdrAnswer mdr = mdr_with(a);
  mdr.stick_radius_first_slip = 0.375 * a;
  mdr.of_kind = LimitingAnswer{1.25};
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
  fe.of_kind = NoWearEvidence{1e-5, 1e-5, 1, 1};
  MdrAnswer mdr = mdr_with(0.5 * a);
  mdr.contact_radius_max = 0.5 * a;  // all of the contact sticks
  mdr.of_kind = LimitingAnswer{1};
  const auto judge = [&] { return outcome_with(mdr, fe) == Outcome::agree; };
  EXPECT_TRUE(judge());
  fe.of_kind = NoWearEvidence{2e-3, 1e-5, 1, 1};
  EXPECT_FALSE(judge());
  mdr.contact_radius_max = 0.6 * a;  // its outer part slips, says MDR as well
  EXPECT_TRUE(judge());
  fe.of_kind = NoWearEvidence{1e-5, 2e-3, 1, 1};
  EXPECT_FALSE(judge());
  fe.of_kind = NoWearEvidence{1e-5, 1e-5, 1.002, 1};
  EXPECT_FALSE(judge());
  fe.of_kind = NoWearEvidence{1e-5, 1e-5, 1, 0.998};
  EXPECT_FALSE(judge());
}

std::optional<Verdict> verdict_with(double difference, double bar) {
  const ErrorBudget budget{{Quantity::stick_radius_shakedown, {{{ErrorSource::rings, bar, std::nullopt}}}}};
  const auto verdict = compare(mdr_with(0.5 * a), fe_with((0.5 + difference) * a), a, tolerances_of(1e-3), budget);
  return verdict.at(Quantity::stick_radius_shakedown).verdict;
}

TEST(Comparison, IsNotResolvedWhereTheErrorBarIsTooWide) {
  EXPECT_EQ(verdict_with(5e-4, 9e-4), Verdict::agree);
  EXPECT_EQ(verdict_with(2e-3, 9e-4), Verdict::disagree);
  EXPECT_EQ(verdict_with(5e-4, 2e-3), Verdict::not_resolved);
  EXPECT_EQ(verdict_with(2e-3, 2e-3), Verdict::not_resolved);
  // So far off that the bar does not matter.
  EXPECT_EQ(verdict_with(4e-3, 2e-3), Verdict::disagree);
  EXPECT_EQ(verdict_with(5e-4, std::numeric_limits<double>::infinity()), Verdict::not_resolved);
}

// A zone that only one of the two finds is a difference of all of it, whatever the bar makes of the rest.
TEST(Comparison, DisagreesWhereOnlyOneSticksBeyondTheBar) {
  const auto verdict = [](std::optional<double> mdr, std::optional<double> fe, double bar) {
    const ErrorBudget budget{{Quantity::stick_radius_shakedown, {{{ErrorSource::rings, bar, std::nullopt}}}}};
    return compare(mdr_with(mdr), fe_with(fe), a, tolerances_of(1e-3), budget)
        .at(Quantity::stick_radius_shakedown)
        .verdict;
  };
  EXPECT_EQ(verdict(0.5 * a, std::nullopt, 2e-3), Verdict::disagree);
  EXPECT_EQ(verdict(std::nullopt, 0.5 * a, 2e-3), Verdict::disagree);
  EXPECT_EQ(verdict(1e-3 * a, std::nullopt, 2e-3), Verdict::not_resolved);
  EXPECT_EQ(verdict(std::nullopt, std::nullopt, 2e-3), Verdict::not_resolved);
  EXPECT_EQ(verdict(std::nullopt, std::nullopt, 5e-4), Verdict::agree);
}

// Without error bars there is no verdict, whatever the difference.
TEST(Comparison, WithoutBarsIsNotProved) {
  for (const double c : {0.5, 0.9}) {
    const auto comparison = compare(mdr_with(0.5 * a), fe_with(c * a), a, tolerances_of(1e-3));
    EXPECT_FALSE(comparison.at(Quantity::stick_radius_shakedown).verdict);
    EXPECT_NEAR(comparison.at(Quantity::stick_radius_shakedown).size(), c - 0.5, 1e-12);
    EXPECT_EQ(outcome_of(comparison), Outcome::not_proved);
    EXPECT_TRUE(passes(outcome_of(comparison)));
  }
  EXPECT_EQ(outcome_of({}), Outcome::not_compared);
}

TEST(Comparison, IsNoBetterThanTheWorstOfWhatWasAskedFor) {
  const auto fe = fe_with(0.5 * a);
  auto budget = bars_of(fe);
  budget[Quantity::normal_force_max].add(ErrorSource::time_step, 1e-3);
  const auto comparison = compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3), budget);
  EXPECT_EQ(outcome_of(comparison), Outcome::not_resolved);
  EXPECT_FALSE(passes(Outcome::not_resolved));
  EXPECT_EQ(comparison.at(Quantity::stick_radius_shakedown).verdict, Verdict::agree);
  budget = bars_of(fe);
  budget.erase(Quantity::normal_force_max);
  EXPECT_EQ(outcome_of(compare(mdr_with(0.5 * a), fe, a, tolerances_of(1e-3), budget)), Outcome::not_proved);
}

/// A tolerance of 0.1, and by which share of the amplitudes each method and the balance of forces have gross slip.
std::optional<Outcome> of_sliding(std::optional<double> fe, std::optional<double> mdr,
                                  std::optional<double> balance = {}, bool along_path = false) {
  Case input;
  input.tolerance = 0.1;
  if (along_path) input.motion.path.emplace();
  auto by_fe = fe_with(0.5 * a);
  auto by_mdr = mdr_with(0.5 * a);
  if (fe) by_fe.of_kind = GrossSlipStart{12, *fe};
  if (mdr) by_mdr.of_kind = GrossSlipShare{*mdr};
  by_mdr.steady_sliding_share = balance;
  return outcome_of_sliding(input, by_fe, by_mdr);
}

// Both have to find it, where the balance of forces has it, and neither before.
TEST(GrossSlip, IsHeldToTheBalanceOfForces) {
  EXPECT_EQ(of_sliding({}, {}), std::nullopt);
  EXPECT_EQ(of_sliding({}, {}, 0.95), std::nullopt) << "within the tolerance";
  EXPECT_EQ(of_sliding({}, {}, 0.811), Outcome::disagree) << "neither finds it";
  EXPECT_EQ(of_sliding(0.933, {}, 0.811), Outcome::disagree) << "one of both";
  EXPECT_EQ(of_sliding(0.933, 0.859, 0.811), Outcome::agree);
  EXPECT_EQ(of_sliding(0.933, 0.65, 0.811), Outcome::disagree) << "too early";
  EXPECT_EQ(of_sliding(0.65, 0.859, 0.811), Outcome::disagree) << "too early";
  EXPECT_EQ(of_sliding(0.933, 0.859, 1.2), Outcome::disagree) << "the steady motion does not slide";
  EXPECT_EQ(of_sliding(0.933, 0.859), Outcome::agree);
}

TEST(GrossSlip, ByOneMethodAloneIsNotResolvedNextToAllOfTheAmplitudes) {
  EXPECT_EQ(of_sliding({}, 0.99), Outcome::not_resolved);
  EXPECT_EQ(of_sliding(0.91, {}), Outcome::not_resolved);
  EXPECT_EQ(of_sliding(0.89, {}), Outcome::disagree);
  EXPECT_EQ(of_sliding({}, 0.89), Outcome::disagree);
  EXPECT_EQ(of_sliding(0.99, {}, 0.811), Outcome::disagree) << "the balance is known";
  EXPECT_EQ(of_sliding({}, 0.7, 1.05), Outcome::not_resolved);
  EXPECT_EQ(of_sliding({}, 1, {}, true), Outcome::disagree) << "along a path";
}

TEST(Comparison, OfACycleIsOverWhatSlidingWouldCost) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycle = some_cycle({0.4, 0.1, 2e-6, 1e-6, 2e-6});
  fe.cycle = some_cycle({0.4002, 0.1005, 2.05e-6, 0.951e-6, 2.002e-6});
  mdr.slip_decay = 0.5;
  fe.slip_decay = fem::DecayFactor{0.501, 0};
  const auto comparison = compare(mdr, fe, a, tolerances_of(1e-3));
  EXPECT_NEAR(*comparison.at(Quantity::tangential_force_max).difference, 5e-4, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::tangential_force_mean).difference, 5e-4, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::friction_work).difference, 5e-4, 1e-12);
  EXPECT_NEAR(*comparison.at(Quantity::cycle_work).difference, 1e-3 / 3, 1e-12);
  EXPECT_EQ(comparison.at(Quantity::friction_work).tolerance, 1e-4) << "a tenth of what a radius is asked for";
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
  EXPECT_EQ(compared.verdict, Verdict::not_resolved);
}

// The springs' own error belongs to the bar, and the tolerance stays what was asked for.
TEST(Comparison, OfTheCyclesToShakedownIsRelativeAndNeedsABar) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycles_to_shakedown = SettlingCycles{10, 0.02};
  fe.cycles_to_shakedown = 10.06;
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).count(Quantity::cycles_to_shakedown), 0U);
  for (const double bar : {5e-3, 2e-3}) {
    const ErrorBudget budget{{Quantity::cycles_to_shakedown, {{{ErrorSource::rings, bar, std::nullopt}}}}};
    const auto compared = compare(mdr, fe, a, tolerances_of(1e-3), budget).at(Quantity::cycles_to_shakedown);
    EXPECT_NEAR(*compared.difference, 6e-3, 1e-12);
    EXPECT_EQ(compared.tolerance, 1e-3);
    EXPECT_NEAR(compared.mdr_error, 2e-3, 1e-12);
    EXPECT_EQ(compared.verdict, bar == 5e-3 ? Verdict::not_resolved : Verdict::disagree);
  }
}

// Without a value of either there is nothing to compare.
TEST(Comparison, OfThePressureOnTheAxisIsRelative) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  fe.axis_pressure_max = 1.0025e5;
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).count(Quantity::axis_pressure_max), 0U);
  mdr.axis_pressure = mdr::AxisPressure{1e5, 0};
  const auto compared = [&] {
    return compare(mdr, fe, a, tolerances_of(1e-3), bars_of(fe)).at(Quantity::axis_pressure_max);
  };
  EXPECT_NEAR(*compared().difference, 2.5e-3, 1e-12);
  EXPECT_EQ(compared().verdict, Verdict::disagree);
  mdr.axis_pressure->error = 200;
  EXPECT_EQ(compared().verdict, Verdict::not_resolved);
}

// What comes along has no part in what becomes of the case unless it disagrees, and is left out where not even the size
// of its bar is known. Its tolerance is no wider for its bar.
TEST(Comparison, OfWhatIsNotAskedForIsToldWithItsBar) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  mdr.cycle = some_cycle({0.4, 0, 2e-6, 0, 2e-6});
  fe.cycle = some_cycle({0.402, 0, 2e-6, 0, 2e-6});
  const auto with_bar = [&](double width) {
    auto budget = bars_of(fe);
    budget[Quantity::tangential_force_max] = {{{ErrorSource::rings, width, std::nullopt}}};
    return compare(mdr, fe, a, tolerances_of(1e-3), budget);
  };
  const auto wide = with_bar(6e-3);
  EXPECT_FALSE(wide.at(Quantity::tangential_force_max).asked);
  EXPECT_EQ(wide.at(Quantity::tangential_force_max).tolerance, 1e-3);
  EXPECT_EQ(wide.at(Quantity::tangential_force_max).verdict, Verdict::not_resolved);
  EXPECT_EQ(outcome_of(wide), Outcome::agree);
  EXPECT_EQ(outcome_of(with_bar(2e-3)), Outcome::disagree);
  EXPECT_EQ(with_bar(std::numeric_limits<double>::infinity()).count(Quantity::tangential_force_max), 0U);
}

TEST(Comparison, OfALargestForceNeedsSpringsThatKnowIt) {
  auto mdr = mdr_with(0.5 * a);
  auto fe = fe_with(0.5 * a);
  const auto known = some_cycle({0.4, 0, 2e-6, 0, 2e-6});
  mdr.cycle = known;
  mdr.cycle->readings.erase(Quantity::tangential_force_max);
  fe.cycle = some_cycle({0.402, 0, 2e-6, 0, 2e-6});
  const auto without = compare(mdr, fe, a, tolerances_of(1e-3));
  EXPECT_EQ(without.count(Quantity::tangential_force_max), 0U);
  EXPECT_EQ(without.count(Quantity::tangential_force_mean), 1U);
  mdr.cycle = known;
  EXPECT_EQ(compare(mdr, fe, a, tolerances_of(1e-3)).count(Quantity::tangential_force_max), 1U);
}

// With a tolerance of its own it has to meet that, a tenth of it for friction over sliding, with the error of the
// springs in its bar.
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
  mdr.cycle = some_cycle({0.4, 0, 2e-6, 0, 2e-6, 4e-4});
  fe.cycle = some_cycle({0.4016, 0, 2e-6, 0, 2e-6});
  const auto with_bar = [&](double width) {
    const ErrorBudget budget{{Quantity::tangential_force_max, {{{ErrorSource::rings, width, std::nullopt}}}}};
    return compare(mdr, fe, a, tolerances, budget).at(Quantity::tangential_force_max);
  };
  EXPECT_EQ(with_bar(3e-3).tolerance, 5e-3);
  EXPECT_TRUE(with_bar(3e-3).asked);
  EXPECT_EQ(with_bar(3e-3).verdict, Verdict::agree);
  EXPECT_EQ(with_bar(4.5e-3).verdict, Verdict::not_resolved) << "the springs are off by 1e-3";
}

}  // namespace
}  // namespace fretval
