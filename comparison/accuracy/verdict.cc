#include "comparison/accuracy/verdict.h"

#include <algorithm>
#include <array>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_values.h"
#include "comparison/simulation/fe_answer.h"

namespace fretval {
namespace {

/// bar: of both methods together. The tolerance is the one that was asked for, and never wider.
Verdict verdict_on(double difference, double tolerance, double bar) {
  if (bar > tolerance && std::abs(difference) <= tolerance + bar) return Verdict::not_resolved;
  return std::abs(difference) <= tolerance ? Verdict::agree : Verdict::disagree;
}

}  // namespace

const char* name_of(Verdict verdict) {
  if (verdict == Verdict::not_resolved) return "not resolved";
  return verdict == Verdict::agree ? "agree" : "disagree";
}

Difference judged(Difference one) {
  if (one.bar)
    one.verdict =
        verdict_on(one.difference.value_or(one.only_one), one.tolerance, one.bar->of_numerics() + one.mdr_error);
  return one;
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

Comparison compare(const Readings& fe, const Readings& mdr, const Scales& scales, const Tolerances& tolerances,
                   const ErrorBudget& budget) {
  Comparison comparison;
  const auto mdr_errors = uncertainties_of(mdr, scales);
  for (const auto& [quantity, reading] : fe) {
    const auto reference = mdr.find(quantity);
    const auto bar = budget.find(quantity);
    if (!reading.is_compared || reference == mdr.end() || !reference->second.is_compared) continue;
    // Quantities of settling are of first order in the step: without a bar it is not known how closely they should
    // agree.
    if (traits_of(quantity).of_settling && bar == budget.end()) continue;
    Difference one{difference_of(quantity, reading, reference->second, scales), tolerance_of(tolerances, quantity)};
    one.only_one = only_one_of(quantity, reading, reference->second, scales);
    one.asked = is_refined_for(quantity, tolerances);
    if (bar != budget.end()) {
      if (!one.asked && !std::isfinite(bar->second.total())) continue;  // not even its size is known
      one.bar = bar->second;
    }
    if (const auto error = mdr_errors.find(quantity); error != mdr_errors.end()) one.mdr_error = error->second;
    comparison[quantity] = judged(one);
  }
  return comparison;
}

const char* name_of(Outcome outcome) {
  // In the order of the enumeration.
  static constexpr std::array names{"agree", "not resolved", "disagree", "not proved", "other model", "not compared"};
  return names[static_cast<std::size_t>(outcome)];
}

Outcome outcome_of(const Comparison& comparison) {
  const auto any = [&](const auto& is) {
    return std::any_of(comparison.begin(), comparison.end(), [&](const auto& entry) { return is(entry.second); });
  };
  if (!any([](const Difference& d) { return d.asked; })) return Outcome::not_compared;
  if (any([](const Difference& d) { return d.verdict == Verdict::disagree; })) return Outcome::disagree;
  if (any([](const Difference& d) { return d.asked && d.verdict == Verdict::not_resolved; }))
    return Outcome::not_resolved;
  return any([](const Difference& d) { return d.asked && !d.verdict; }) ? Outcome::not_proved : Outcome::agree;
}

std::optional<Outcome> outcome_of_sliding(const Case& input, const FeAnswer& fe_answer, const MdrAnswer& mdr_answer) {
  const auto* fe = fe_answer.as<GrossSlipStart>();
  const auto* mdr = mdr_answer.as<GrossSlipShare>();
  const auto& balance = mdr_answer.steady_sliding_share;
  const double tolerance = input.tolerance;
  const bool must = balance && *balance < 1 - tolerance, may = !balance || *balance <= 1 + tolerance;
  if (!fe && !mdr) return must ? std::optional(Outcome::disagree) : std::nullopt;
  if (!fe || !mdr) {
    const double share = balance.value_or(fe ? fe->amplitude : mdr->amplitude);
    return !input.motion.path && std::abs(share - 1) <= tolerance ? Outcome::not_resolved : Outcome::disagree;
  }
  const bool too_early = balance && std::min(fe->amplitude, mdr->amplitude) < *balance - tolerance;
  return may && !too_early ? Outcome::agree : Outcome::disagree;
}

}  // namespace fretval
