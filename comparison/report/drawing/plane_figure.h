#pragma once

#include <optional>

#include "comparison/quantities/plane_edges.h"
#include "comparison/report/drawing/figures.h"

namespace fretval {

/// Radii of the zones by MDR, m; empty: MDR has none.
struct MdrRadii {
  std::optional<double> contact, never_slipped, sticks_in_a_cycle;
};

/// The contact from above: edges of the contact and of the zones that have never slipped and that stick in a cycle,
/// beside circles of MDR's radii.
Figure edges_figure(const PlaneEdges& edges, const MdrRadii& mdr);

/// The contact from above at the end of the last cycle of a contact on rings and angles: edges of the contact and of
/// the zones that have never slipped and that stick in a cycle, and the traction on the body as arrows. Drawn from the
/// files zones.csv and surface.csv of a case.
Figure plane_figure(const StoredResult& result);

}  // namespace fretval
