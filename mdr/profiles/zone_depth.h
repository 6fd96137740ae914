#pragma once

#include <optional>

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// Depth by which the radius c of a zone is told where springs are coupled: g(c), and within a flat face of radius b,
/// where g is 0 but not all springs slip at once, -(1 - c/b) g(2 b). Rises with c, without a jump. c >= 0 in m.
double zone_depth(const Profile& profile, double radius);

/// The radius c in m with that zone_depth(); empty: it would be negative, so that there is no zone.
std::optional<double> zone_radius(const Profile& profile, double depth);

}  // namespace fretval::mdr
