#pragma once

#include <optional>
#include <vector>

#include "comparison/accuracy/computations.h"
#include "comparison/accuracy/error_budget.h"

namespace fretval {

/// How far the ends of an annulus may be off, over the unit of length. Empty: refinements have other zones, so that
/// nothing is known; or the inner end of a disc.
struct AnnulusBar {
  std::optional<ErrorBar> inner, outer;
};

/// The bars of a ZoneAnswer, annulus by annulus, and that of the largest pressure, relative.
struct ZoneBudget {
  std::vector<AnnulusBar> contact, first_slip, shakedown;
  ErrorBar pressure_max;
};

/// Each source by its own refinement, like all bars (error_budget). Zones of refinements are told apart by their number
/// and order alone, and ends of stick zones are no better known than to the ring that may stick or slip: half of it is
/// a share of the bar, that of the edge.
ZoneBudget zone_budget(const Resolution& resolution, const Computations& computed, const CaseNeeds& needs);

}  // namespace fretval
