#pragma once

#include <optional>

#include "comparison/quantities/plane_edges.h"
#include "comparison/report/drawing/figures.h"

namespace fretval {

/// Radii of zones as MDR has them, m; empty: it has none.
struct MdrRadii {
  std::optional<double> contact, never_slipped, sticks_in_a_cycle;
};

/// The contact from above: edges of the contact and of both zones that stick, beside circles of MDR's radii.
Figure edges_figure(const PlaneEdges& edges, const MdrRadii& mdr);

/// The contact from above at the end of the last cycle of a contact on rings and angles: edges of the contact and of
/// both zones that stick, and the traction on the body as arrows. Of the files zones.csv and surface.csv of a case.
Figure plane_figure(const StoredResult& result);

}  // namespace fretval
