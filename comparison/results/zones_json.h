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

/// The key "not_compared". depth: the largest indentation in m.
nlohmann::ordered_json to_json(const BeyondMdr& beyond, double depth);

/// "its image g(x) falls for x = 502 to 600 µm. MDR's springs would bear +3.1 % and reach -0.2 % further, at rest at
/// the largest indentation": of the key "not_compared".
std::string beyond_text(const nlohmann::ordered_json& not_compared);

/// "0 to 502.1 ± 0.4 µm, 610 ± 1 to 702 ± 1 µm", of a list of annuli in such a JSON; "none" without any.
std::string annuli_text(const nlohmann::ordered_json& annuli);

}  // namespace fretval
