#pragma once

#include "fem/normal_history.h"
#include "fem/punch_series.h"

namespace fretval::fem {

/// How uncertain the forces of the last cycle are where the gap has a kink that no ring shows (see ContactForce), from
/// a second reading. The edge of the contact moves smoothly in time up to the largest contact and away from it, so at
/// such an instant it also lies on the cubic through that and three instants on the same side whose kinks are seen, as
/// far apart as the kink is hidden for. Twice what this makes of the force replaces what was set aside for the kink,
/// where it is less; without three such instants nothing changes. A Kelvin-Voigt body at 96 rings: 1.1e-6 instead of
/// 2.3e-5 of the force, for an error of 1.3e-7.
///
/// largest_radius: of the contact, at the largest indentation, with which a cycle begins and ends.
void judge_unseen_kinks(const PunchSeries& series, double largest_radius, NormalHistory& history);

}  // namespace fretval::fem
