#pragma once

#include "comparison/accuracy/error_budget.h"
#include "comparison/accuracy/tracks.h"

namespace fretval {

/// What the errors of a case depend on.
CaseNeeds needs_of(const FemCase& fem);

/// Which shares a bar has: all, or that of the rings alone, which takes a third of the computations and is mostly the
/// one that makes a bar too wide.
enum class BarShares { of_rings, all };

/// All that has to be computed for the error bars: tracks, variants and the references of the variants.
std::vector<Resolution> needed_for_bars(const Tracks& tracks, const CaseNeeds& needs,
                                        BarShares shares = BarShares::all);

/// Whether a bar of a stick radius includes the case that nothing sticks, where the error of a depth leaves that open.
/// To refine for such a border would cost hundreds of rings and decide nothing, so that it is carried only by bars that
/// are not refined any further.
enum class Borders { left_out, carried };

/// The error bar of each quantity at the resolution that it is read from.
ErrorBudget error_bars(const PreparedCase& prepared, const Tracks& tracks, const Computations& computed,
                       Borders borders, BarShares shares = BarShares::all);

}  // namespace fretval
