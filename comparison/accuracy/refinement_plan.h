#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "comparison/accuracy/error_budget.h"
#include "comparison/simulation/fem_case/resolution.h"

namespace fretval {

/// An error bar, and how wide it may be.
struct BarToMeet {
  ErrorBar bar;
  double tolerance;
};

/// Size of a computation, in numbers that are the same on every machine.
struct Effort {
  double n_dofs;        ///< of all harmonics
  double n_rings;       ///< on the contact line
  double n_steps;       ///< of the friction history
  double n_angles = 0;  ///< of the full contact; 0: the ring contact
};

/// Two refinements are enough for shares up to this many tolerances; no order can be trusted further.
constexpr double most_tolerances = 15;

/// Rough seconds of a computation of this size: 1e-5 n_dofs for the body, and for a history 1e-5 n_steps
/// (n_rings/48)^1.4 or, of the full contact, 2.7e-8 n_steps n_angles^1.25 n_rings^2.
double expected_seconds(const Effort& effort);

/// The cheapest refinement that is expected to bring all bars within their tolerances: of all combinations of up to two
/// refinements (see refined) of each source, judged by how much they reduce its share (by the observed order, or the
/// lowest that is usual) and add to the effort. Where none is enough, it is the one that gets closest for its cost.
/// most_times: largest factor by which the expected seconds may grow. Empty: no bar is too wide, or nothing can be
/// refined that would help.
std::optional<Resolution> planned_refinement(const Resolution& resolution, const std::vector<BarToMeet>& bars,
                                             const Effort& effort, const FixedByCase& fixed,
                                             double most_times = std::numeric_limits<double>::infinity());

}  // namespace fretval
