#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/case/case.h"

namespace fretval {

/// What a case file prescribes, for people: a list of {section, name, value, unit}, named as in the file, in SI units;
/// value a number, a list or words, unit empty where there is none.
nlohmann::ordered_json inputs_json(const Case& input);

}  // namespace fretval
