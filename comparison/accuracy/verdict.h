#pragma once

#include <cmath>
#include <map>
#include <optional>

#include "comparison/accuracy/error_budget.h"
#include "comparison/quantities/reading.h"

namespace fretval {

/// What a comparison comes to: the difference and the error bar are within the tolerance; the bar is wider than that,
/// so that nobody can tell; the difference is larger than the tolerance, and a wider bar does not explain it.
enum class Verdict { agree, not_resolved, disagree };
const char* name_of(Verdict verdict);

/// bar: of both methods together. The tolerance is the one that was asked for, and never wider.
Verdict verdict_on(double difference, double tolerance, double bar);

/// One quantity compared.
struct Difference {
  std::optional<double>
      difference;  ///< finite elements less MDR over the scale; empty: nothing sticks, says one or both
  double tolerance = 0;
  std::optional<Verdict> verdict = {};  ///< empty: without an error bar nothing is proved
  std::optional<ErrorBar> bar = {};     ///< of the finite elements; empty: not measured
  double mdr_error = 0;                 ///< what MDR's springs may be off by, over the same scale
  bool asked = true;                    ///< for; otherwise it comes along, and is told with its bar
  double only_one = 0;                  ///< without a difference: what only one of the two finds, over the scale

  [[nodiscard]] double size() const { return std::abs(difference.value_or(only_one)); }
};

/// With the verdict on it.
Difference judged(Difference one);

/// How far finite elements and MDR may lie apart.
struct Tolerances {
  double stick_radius;               ///< over the unworn contact radius at the largest indentation
  double contact_radius;             ///< relative
  double normal_force;               ///< relative, also on the indentation where the force is prescribed
  std::optional<double> cycle = {};  ///< before its strictness, on forces and energies of a cycle; empty: none
};

/// What a case asks for: T = Accuracy / Tolerance over the strictness of each quantity.
Tolerances tolerances_of(double accuracy, std::optional<double> of_cycle = {});

/// The tolerance of a quantity: that on the stick radius unless it has one of its own.
double tolerance_of(const Tolerances& tolerances, Quantity quantity);

/// Whether the bar of a quantity has to meet its tolerance.
bool is_refined_for(Quantity quantity, const Tolerances& tolerances);

/// What both methods have is compared, over the scale of each quantity. Where one of the two says that nothing sticks,
/// the other must say so too or find a stick zone smaller than the tolerance. Whether a comparison passes is
/// verdict_on, with the error bar of the finite elements.
using Comparison = std::map<Quantity, Difference>;

/// budget: empty if none was measured. Nothing is compared that either method says the whole contact slides in.
Comparison compare(const Readings& fe, const Readings& mdr, const Scales& scales, const Tolerances& tolerances,
                   const ErrorBudget& budget = {});

/// What becomes of a case: of its comparisons those that were asked for have to agree, and none may disagree.
/// not_proved: there are no error bars, and so no verdict, whatever the differences. other_model: MDR does not compute
/// the body or the contact of the case, so that the differences tell how far it is off. not_compared: MDR does not
/// hold.
enum class Outcome { agree, not_resolved, disagree, not_proved, other_model, not_compared };
const char* name_of(Outcome outcome);

Outcome outcome_of(const Comparison& comparison);

/// Nothing speaks against it.
inline bool passes(Outcome outcome) {
  return outcome != Outcome::not_resolved && outcome != Outcome::disagree;
}

}  // namespace fretval
