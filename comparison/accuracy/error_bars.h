#pragma once

#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/tracks.h"

namespace fretval {

/// What the errors of a case depend on.
CaseNeeds needs_of(const FemCase& fem);

/// Which shares a bar has: all, or those of the rings alone, which take a third of the computations and are mostly what
/// makes it too wide.
enum class BarShares { of_rings, all };

/// All that has to be computed for the error bars: tracks, variants and the references of those.
std::vector<Resolution> needed_for_bars(const Tracks& tracks, const CaseNeeds& needs,
                                        BarShares shares = BarShares::all);

/// Whether a bar also has to tell if anything sticks at all, where the error of a depth leaves that open. Refining for
/// it costs hundreds of rings, and does not decide what a border leaves open, so only bars that are taken as they are
/// carry it.
enum class Borders { left_out, carried };

/// The error bar of each quantity at the resolution that it is read from.
ErrorBudget error_bars(const PreparedCase& prepared, const Tracks& tracks, const Computations& computed,
                       Borders borders, BarShares shares = BarShares::all);

/// The same of what the normal motion decides alone, from compute_normal_response.
ErrorBudget error_bars_of_normal_response(const PreparedCase& prepared, const Resolution& resolution,
                                          const Computations& computed);

}  // namespace fretval
