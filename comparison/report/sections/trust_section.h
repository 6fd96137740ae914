#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/report/text/filling.h"

namespace fretval {

/// For the template `trust`: how far MDR can be trusted in a case, of a trust.json (see ladder_json): the headline, the
/// ladder of assumptions as a waterfall and as a table, the maps of MDR's error with the case on them, what is not
/// computed, how it was computed in words that can be copied, and the inputs. Throws InputError for another JSON.
Filling trust_section(const nlohmann::ordered_json& trust);

}  // namespace fretval
