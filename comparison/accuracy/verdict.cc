#include "comparison/accuracy/verdict.h"

#include <algorithm>
#include <cmath>

namespace fretval {
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

Comparison compare(const Readings& fe, const Readings& mdr, const Scales& scales, const Tolerances& tolerances,
                   const ErrorBudget& budget) {
  Comparison comparison;
  const auto mdr_errors = uncertainties_of(mdr, scales);
  for (const auto& [quantity, reading] : fe) {
    const auto reference = mdr.find(quantity);
    const auto bar = budget.find(quantity);
    if (!reading.is_compared || reference == mdr.end() || !reference->second.is_compared) continue;
    // Of first order in the step, so that without a bar nothing is known of how closely it should agree.
    if (traits_of(quantity).of_settling && bar == budget.end()) continue;
    Difference one{difference_of(quantity, reading, reference->second, scales), tolerance_of(tolerances, quantity)};
    one.only_one = only_one_of(quantity, reading, reference->second, scales);
    double total = 0;
    if (bar != budget.end()) {
      one.bar = bar->second;
      total = one.bar->total();
      const bool comes_along = !is_refined_for(quantity, tolerances);
      if (comes_along && !std::isfinite(total)) continue;  // not even its size is known
      if (comes_along) one.tolerance = std::max(one.tolerance, total);
    }
    if (const auto error = mdr_errors.find(quantity); error != mdr_errors.end()) one.tolerance += error->second;
    one.verdict = verdict_on(one.difference.value_or(one.only_one), one.tolerance, total);
    comparison[quantity] = one;
  }
  return comparison;
}

bool passes(const Comparison& comparison) {
  return std::all_of(comparison.begin(), comparison.end(), [](const auto& entry) { return entry.second.passes(); });
}

}  // namespace fretval
