#pragma once

#include <map>
#include <optional>

#include "comparison/accuracy/error_budget.h"
#include "comparison/quantities/reading.h"

namespace fretval {

/// What a comparison comes to.
enum class Verdict { pass, fail, inconclusive };
const char* name_of(Verdict verdict);

/// Pass or fail by the tolerance; inconclusive if the error bar is wider than that, unless the difference is larger
/// than both together.
Verdict verdict_on(double difference, double tolerance, double bar = 0);

/// One quantity compared.
struct Difference {
  std::optional<double> difference;  ///< finite elements less MDR, relative; empty: nothing sticks, says one or both
  double tolerance;
  Verdict verdict = Verdict::pass;
  std::optional<ErrorBar> bar = {};  ///< of the finite elements; empty: not measured
  double only_one = 0;               ///< without a difference: the stick radius that only one of the two finds

  [[nodiscard]] bool passes() const { return verdict == Verdict::pass; }
};

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

bool passes(const Comparison& comparison);

}  // namespace fretval
