#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/results/case_result.h"

namespace fretval {

/// The key "zones" of finite elements in result.json: `contact`, `first_slip`, `shakedown`, each a list of annuli from
/// the axis outwards, with `inner`, `outer` and their bars `inner_bar`, `outer_bar` in m (null: none was measured, or
/// refinements have other zones; of the centre of a disc); `why_no_radius`, by zone, of a stick zone that is not one
/// disc, else null; `contact_uncertainty`, m; `pressure_max_bar`, Pa. length: the unit of the bars, m.
nlohmann::ordered_json zones_json(const ZoneAnswer& zones, const std::optional<ZoneBudget>& bars, double length);

/// The same of the contact on rings and angles: `never_slipped`, `sticks_in_a_cycle` (not of a single pass) and
/// `contact`, each with `area` in m², `radius` of the disc of that area, half of its extents `along` x and `across`, in
/// m, and their bars (null: none was measured); `torque_max` in N m. budget: over the unit of length.
nlohmann::ordered_json zones_json(const SurfaceAnswer& surface, Course course, const ErrorBudget& budget,
                                  double length);

/// The key "not_compared". depth: the largest indentation in m.
nlohmann::ordered_json to_json(const BeyondMdr& beyond, double depth);

}  // namespace fretval
