#pragma once

#include <cmath>
#include <map>
#include <optional>

#include "comparison/accuracy/error_budget.h"
#include "comparison/quantities/reading.h"

namespace fretval {

struct Case;
struct FeAnswer;
struct MdrAnswer;

/// Result of a comparison. agree: difference and error bar are within the tolerance; not_resolved: the bar is wider
/// than the tolerance, so that the comparison decides nothing; disagree: the difference is larger than the tolerance,
/// and the bar does not explain it.
enum class Verdict { agree, not_resolved, disagree };
const char* name_of(Verdict verdict);

/// One quantity compared.
struct Difference {
  std::optional<double>
      difference;  ///< finite elements less MDR over the scale; empty: nothing sticks, says one or both
  double tolerance = 0;
  std::optional<Verdict> verdict = {};  ///< empty: without an error bar nothing is proved
  std::optional<ErrorBar> bar = {};     ///< error bar of the finite elements; empty: not measured
  double mdr_error = 0;                 ///< error of MDR's springs, over the same scale
  bool asked = true;                    ///< whether the quantity is asked for; otherwise it is only told, with its bar
  double only_one = 0;                  ///< without a difference: what only one of the two finds, over the scale

  [[nodiscard]] double size() const { return std::abs(difference.value_or(only_one)); }
};

/// The difference with the verdict on it.
Difference judged(Difference one);

/// How far finite elements and MDR may lie apart.
struct Tolerances {
  double stick_radius;               ///< over the unworn contact radius at the largest indentation
  double contact_radius;             ///< relative
  double normal_force;               ///< relative, also on the indentation where the force is prescribed
  std::optional<double> cycle = {};  ///< on forces and energies of a cycle, times their strictness; empty: none
};

/// Tolerances of a case: T = Accuracy / Tolerance, over the strictness of each quantity. of_cycle: that on forces and
/// energies of a cycle.
Tolerances tolerances_of(double accuracy, std::optional<double> of_cycle = {});

/// The tolerance of a quantity: that on the stick radius unless it has one of its own.
double tolerance_of(const Tolerances& tolerances, Quantity quantity);

/// Whether the bar of a quantity has to meet its tolerance.
bool is_refined_for(Quantity quantity, const Tolerances& tolerances);

/// Differences of the quantities that both methods have, over the scale of each. Where one of the two says that nothing
/// sticks, the other must say so, too, or find a stick zone smaller than the tolerance. judged() decides, with the
/// error bar of the finite elements, whether a comparison passes.
using Comparison = std::map<Quantity, Difference>;

/// Compares the readings of both methods. budget: empty if none was measured. Nothing is compared where either method
/// finds that the whole contact slides.
Comparison compare(const Readings& fe, const Readings& mdr, const Scales& scales, const Tolerances& tolerances,
                   const ErrorBudget& budget = {});

/// Result of a case. To agree, all comparisons that were asked for have to agree, and none may disagree. not_proved:
/// there are no error bars, and so no verdict, whatever the differences. other_model: MDR does not compute the body or
/// the contact of the case, so that the differences tell how far MDR is off. not_compared: MDR does not hold.
enum class Outcome { agree, not_resolved, disagree, not_proved, other_model, not_compared };
const char* name_of(Outcome outcome);

Outcome outcome_of(const Comparison& comparison);

/// The outcome of a case in which the whole contact slides by either method or by the balance of forces
/// (MdrAnswer::steady_sliding_share); empty: in no case of these. If one method finds gross slip, the other has to find
/// it, too, as have both where the balance demands it; neither may begin to slide below that share. not_resolved: one
/// method alone finds it, and the share of the amplitudes at which the balance or, where that is not known, this method
/// has it is within the tolerance of 1. Of a path no share is known.
std::optional<Outcome> outcome_of_sliding(const Case& input, const FeAnswer& fe, const MdrAnswer& mdr);

/// Whether no comparison speaks against the case.
inline bool passes(Outcome outcome) {
  return outcome != Outcome::not_resolved && outcome != Outcome::disagree;
}

}  // namespace fretval
