#pragma once

#include <optional>
#include <vector>

#include "comparison/accuracy/computations.h"
#include "comparison/accuracy/error_budget.h"

namespace fretval {

/// Error bars of the ends of an annulus, over the unit of length. Empty: not known, as refinements have other zones; or
/// the inner end of a disc.
struct AnnulusBar {
  std::optional<ErrorBar> inner, outer;
};

/// The bars of a ZoneAnswer, annulus by annulus, and the relative bar of its largest pressure.
struct ZoneBudget {
  std::vector<AnnulusBar> contact, first_slip, shakedown;
  ErrorBar pressure_max;
};

/// The bars of the zones, each source by its own refinement as in error_budget(). Zones of refinements are matched by
/// their number and order alone. Ends of stick zones are known no better than to the ring that may stick or slip: half
/// of that ring is the share of the edge.
ZoneBudget zone_budget(const Resolution& resolution, const Computations& computed, const CaseNeeds& needs);

}  // namespace fretval
