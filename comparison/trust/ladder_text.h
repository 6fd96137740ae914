#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparison/trust/ladder.h"

namespace fretval {

/// "MDR's shakedown radius is 20 % ± 0.002 % too small here: a layer 2 mm thick, a/H = 0.69 (-20 %)": of the shakedown
/// radius or, where there is none, the first-slip or the contact radius; in brackets by how much MDR is off for each
/// assumption alone, coupling against all the others.
std::string headline_of(const Ladder& ladder);

/// Headline, a table of quantities by rungs, and what is not computed, for the terminal.
std::string ladder_text(const std::string& name, const Ladder& ladder);

/// Titles of the radii in which MDR's own model is off by more than a share, whatever the bars leave open; empty: none.
std::string radii_beyond(double share, const Ladder& ladder);

/// trust.json, see docs/results.md; SI units.
nlohmann::ordered_json ladder_json(const Case& input, const Ladder& ladder);

}  // namespace fretval
