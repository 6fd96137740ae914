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

/// The same of any case. Of the contact on rings and angles: `never_slipped`, `sticks_in_a_cycle` (not of a single
/// pass) and `contact`, each with `area` in m², `radius` of the disc of that area, half of its extents `along` x and
/// `across`, in m, and their bars (null: none was measured); `torque_max` in N m. Null: zones are discs.
nlohmann::ordered_json zones_json(const CaseResult& result);

/// The key "not_compared": where the image of the profile falls, and by how much MDR's springs would be off, if nobody
/// asked (mdr::naive_contact), of the relaxed body that rests at the largest indentation. SI units.
nlohmann::ordered_json not_compared_json(const CaseResult& result);

}  // namespace fretval
