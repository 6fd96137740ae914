#pragma once

#include "fem/condensation/punch_series.h"
#include "fem/history/normal_history.h"

namespace fretval::fem {

/// Forces of the last cycle where the gap has a kink that no ring shows (see ContactForce), from a second reading of
/// the edge. It moves smoothly in time up to the largest contact and away from it, so at such an instant it also lies
/// on the cubic through that and three instants on the same side whose kinks are seen, half as far apart as the kink is
/// hidden for if the half cycle has room for it.
///
/// The first reading supposes that the gap goes on inside the kink as it does outside, which is right where the body is
/// mildly viscous. If the forces of both differ by no more than what was set aside for the kink, it stands, uncertain
/// by twice the difference (Kelvin-Voigt at 96 rings: 1.1e-6 instead of 2.3e-5 of the force, for an error of 1.3e-7).
/// If by more, the supposition is wrong (a dashpot of omega eta = 1e3 G0: the edge was read next to the kink, half a
/// ring too far outside, and the force was 5.5e-3 off at 8 to 24 rings alike, 2e-5 to 4e-4 now from 12 on) and the
/// second reading is taken: uncertain by twice its difference from a parabola without the farthest instant, and by a
/// tenth of that from the first reading (a seventh was missed where few rings see the kink).
///
/// Without three such instants the edge is anywhere from the last closed ring to the first reading.
///
/// largest_radius: of the contact, at the largest indentation, with which a cycle begins and ends.
void read_edges_near_largest_contact(const PunchSeries& series, double largest_radius, NormalHistory& history);

}  // namespace fretval::fem
