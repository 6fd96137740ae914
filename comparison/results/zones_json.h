#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/results/case_result.h"

namespace fretval {

/// The key "zones" of finite elements in result.json: `contact`, `first_slip`, `shakedown`, each a list of annuli from
/// the axis outwards, with `inner`, `outer` and their bars `inner_bar`, `outer_bar` in m (null: none was measured,
/// refinements have other zones, or it is the centre of a disc); `why_no_radius`, by zone: why a stick zone is not one
/// disc, otherwise null; `contact_uncertainty`, m; `pressure_max_bar`, Pa. length: the unit of the bars, m.
nlohmann::ordered_json zones_json(const ZoneAnswer& zones, const std::optional<ZoneBudget>& bars, double length);

/// The key "zones" of a case of any kind. For the contact on rings and angles it has `never_slipped`,
/// `sticks_in_a_cycle` (not for a single pass) and `contact`, each with `area` in m², `radius` of the disc of that
/// area, half of its extents `along` x and `across`, in m, and their bars (null: none was measured); `torque_max` in N
/// m. Null: zones are discs.
nlohmann::ordered_json zones_json(const CaseResult& result);

/// The key "not_compared": where the image of the profile falls, and the errors that MDR's springs would make
/// (mdr::naive_contact) for the relaxed body at rest at the largest indentation. SI units.
nlohmann::ordered_json not_compared_json(const CaseResult& result);

}  // namespace fretval
