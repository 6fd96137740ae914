#pragma once

#include "fem/condensation/punch_series.h"
#include "fem/history/normal_history.h"

namespace fretval::fem {

/// Edge and force of the last cycle where the gap has a kink that no ring shows (see ContactForce). Read from the gap
/// they suppose that it goes on inside the kink as it does outside, which is right where the body is mildly viscous:
/// with a dashpot of omega eta = 1e3 G0 the edge is next to the kink, half a ring too far outside, and the force 5.5e-3
/// off at 8 to 24 rings alike. But the edge moves smoothly in time up to the largest contact and away from it. So at
/// such an instant it lies on the cubic through that and three instants on the same side whose kinks are seen, half as
/// far apart as the kink is hidden for if the half cycle has room for it.
///
/// Without three such instants the edge is anywhere from the last closed ring to where it was read.
///
/// largest_radius: of the contact, at the largest indentation, with which a cycle begins and ends.
void read_edges_near_largest_contact(const PunchSeries& series, double largest_radius, NormalHistory& history);

}  // namespace fretval::fem
