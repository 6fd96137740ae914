#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// What a case file prescribes, for people: a list of {section, name, value, unit}, named as in the file, in SI units;
/// value a number, a list or words, unit empty where there is none. Zeros that were set are listed. Names tell where
/// values were fitted to measured moduli, or times shifted to a temperature.
nlohmann::ordered_json inputs_json(const Case& input);

/// A value and its unit as text, with the prefix that leaves one to three digits before the point where the unit takes
/// one: "100 µm", "2 MPa, 500 kPa", "parabola", "60°".
std::string input_text(const nlohmann::ordered_json& value, const std::string& unit, int digits);

/// Whether a unit takes prefixes.
bool takes_prefixes(const std::string& unit);

}  // namespace fretval
