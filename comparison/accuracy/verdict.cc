#include "comparison/accuracy/verdict.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "comparison/accuracy/compared_quantities.h"

namespace fretval {
namespace {

Difference judge(double difference, double tolerance) {
  return {difference, tolerance, verdict_on(difference, tolerance)};
}

Difference judge_stick(const std::optional<double>& fe, const std::optional<double>& mdr, double contact_radius,
                       double tolerance) {
  auto judged = judge((fe.value_or(0) - mdr.value_or(0)) / contact_radius, tolerance);
  if (!fe || !mdr) judged.only_one = std::exchange(judged.difference, std::nullopt).value();
  return judged;
}

}  // namespace

Verdict verdict_on(double difference, double tolerance, double bar) {
  if (bar > tolerance && std::abs(difference) <= tolerance + bar) return Verdict::inconclusive;
  return std::abs(difference) <= tolerance ? Verdict::pass : Verdict::fail;
}

const char* name_of(Verdict verdict) {
  if (verdict == Verdict::inconclusive) return "inconclusive";
  return verdict == Verdict::pass ? "pass" : "fail";
}

Tolerances tolerances_of(double accuracy, std::optional<double> of_cycle) {
  const auto over = [accuracy](Quantity quantity) { return accuracy / traits_of(quantity).strictness; };
  return {over(Quantity::stick_radius_shakedown), over(Quantity::contact_radius_max), over(Quantity::normal_force_max),
          of_cycle};
}

double tolerance_of(const Tolerances& tolerances, Quantity quantity) {
  if (quantity == Quantity::contact_radius_max) return tolerances.contact_radius;
  if (quantity == Quantity::normal_force_max || quantity == Quantity::indentation_max) return tolerances.normal_force;
  const auto& traits = traits_of(quantity);
  const bool of_cycle = traits.refined_for == RefinedFor::cycles;
  return (of_cycle ? tolerances.cycle.value_or(tolerances.stick_radius) : tolerances.stick_radius) / traits.strictness;
}

bool is_refined_for(Quantity quantity, const Tolerances& tolerances) {
  const auto refined_for = traits_of(quantity).refined_for;
  return refined_for == RefinedFor::any_case || (refined_for == RefinedFor::cycles && tolerances.cycle);
}

namespace {

Difference judge_relative(const std::optional<double>& fe, const std::optional<double>& mdr, double tolerance) {
  return judge(fe.value() / mdr.value() - 1, tolerance);
}

void compare_responses(const MdrAnswer& mdr, const FeAnswer& fe, const Tolerances& tolerances, Comparison& comparison) {
  if (fe.indentation_max)
    comparison[Quantity::indentation_max] =
        judge_relative(fe.indentation_max, mdr.indentation_max, tolerances.normal_force);
  else
    comparison[Quantity::normal_force_max] =
        judge_relative(fe.normal_force_max, mdr.normal_force_max, tolerances.normal_force);
  if (fe.axis_pressure_max && mdr.axis_pressure)
    comparison[Quantity::axis_pressure_max] = judge_relative(fe.axis_pressure_max, mdr.axis_pressure->largest,
                                                             tolerance_of(tolerances, Quantity::axis_pressure_max));
  if (fe.tangential_amplitude)
    comparison[Quantity::tangential_amplitude] =
        judge_relative(fe.tangential_amplitude, mdr.tangential_amplitude, tolerances.stick_radius);
}

void compare_cycles(const MdrCycle& mdr, const fem::CycleResponse& fe, const Tolerances& tolerances,
                    Comparison& comparison) {
  const auto add = [&](Quantity quantity, double fe_value, double mdr_value, double scale) {
    comparison[quantity] = judge((fe_value - mdr_value) / scale, tolerance_of(tolerances, quantity));
  };
  if (mdr.knows_largest_force)
    add(Quantity::tangential_force_max, fe.tangential_force_max, mdr.tangential_force_max, mdr.tangential_force_max);
  add(Quantity::tangential_force_mean, fe.tangential_force_mean, mdr.tangential_force_mean, mdr.sliding_force);
  add(Quantity::friction_work, fe.friction_work, mdr.friction_work, mdr.sliding_work);
  const double fe_loss = fe.friction_work + fe.bulk_work, mdr_loss = mdr.friction_work + mdr.bulk_work;
  if (!(fe.bulk_work > 0 && mdr.bulk_work > 0)) return;
  add(Quantity::cycle_work, fe_loss, mdr_loss, mdr_loss);
  add(Quantity::bulk_work, fe.bulk_work, mdr.bulk_work, mdr.bulk_work);
  add(Quantity::tangential_work, fe.tangential_work, mdr.tangential_work, mdr.tangential_work);
}

}  // namespace

Comparison compare(const MdrAnswer& mdr, const FeAnswer& fe, double unworn_radius, const Tolerances& tolerances,
                   const ErrorBudget& budget) {
  Comparison comparison;
  if (fe.gross_slip || mdr.gross_slip) return comparison;
  if (fe.contact_radius_max)
    comparison[Quantity::contact_radius_max] =
        judge(*fe.contact_radius_max / mdr.contact_radius_max.value() - 1, tolerances.contact_radius);
  compare_responses(mdr, fe, tolerances, comparison);
  if (fe.cycle && mdr.cycle) compare_cycles(*mdr.cycle, *fe.cycle, tolerances, comparison);
  const double tolerance = tolerances.stick_radius;
  // Of first order in the step, so that without a bar nothing is known of how closely it should agree.
  if (fe.slip_decay && mdr.slip_decay && budget.count(Quantity::slip_decay) > 0)
    comparison[Quantity::slip_decay] = judge(fe.slip_decay->factor / *mdr.slip_decay - 1, tolerance);
  if (fe.cycles_to_shakedown && mdr.cycles_to_shakedown && budget.count(Quantity::cycles_to_shakedown) > 0)
    comparison[Quantity::cycles_to_shakedown] =
        judge_relative(fe.cycles_to_shakedown, mdr.cycles_to_shakedown->cycles, tolerance);
  comparison[Quantity::stick_radius_first_slip] =
      judge_stick(fe.stick_radius_first_slip, mdr.stick_radius_first_slip, unworn_radius, tolerance);
  if (!fe.single_pass)
    comparison[Quantity::stick_radius_shakedown] =
        judge_stick(fe.stick_radius_shakedown, mdr.stick_radius_shakedown, unworn_radius, tolerance);
  if (fe.no_wear) {
    if (mdr.wears_no_more()) comparison[Quantity::slip_inside_stick_zone] = judge(fe.no_wear->slip_inside, tolerance);
    comparison[Quantity::force_outside_stick_zone] = judge(fe.no_wear->force_outside, tolerance);
    comparison[Quantity::maximum_indentation] = judge(fe.no_wear->touch_indentation - 1, tolerance);
    if (fe.no_wear->limiting_amplitude && mdr.limiting_amplitude)
      comparison[Quantity::limiting_amplitude] =
          judge(*fe.no_wear->limiting_amplitude - *mdr.limiting_amplitude, tolerance);
  }
  const auto stepping_errors = stepping_errors_of(mdr);
  for (auto next = comparison.begin(); next != comparison.end();) {
    const auto entry = next++;
    auto& [quantity, difference] = *entry;
    double total = 0;
    if (const auto bar = budget.find(quantity); bar != budget.end()) {
      total = bar->second.total();
      if (!is_refined_for(quantity, tolerances)) {
        if (!std::isfinite(total)) {
          comparison.erase(entry);  // not even its size is known
          continue;
        }
        difference.tolerance = std::max(difference.tolerance, total);
      }
      difference.bar = bar->second;
    }
    if (const auto error = stepping_errors.find(quantity); error != stepping_errors.end())
      difference.tolerance += error->second;
    difference.verdict = verdict_on(difference.difference.value_or(difference.only_one), difference.tolerance, total);
  }
  return comparison;
}

bool passes(const Comparison& comparison) {
  return std::all_of(comparison.begin(), comparison.end(), [](const auto& entry) { return entry.second.passes(); });
}

}  // namespace fretval
