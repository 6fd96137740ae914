#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparison/trust/ladder.h"

namespace fretval {

/// "MDR's shakedown radius is 20 % ± 0.002 % too small here: a layer 2 mm thick, a/H = 0.69 (+25 %)": of the shakedown
/// radius or, where there is none, the first-slip or the contact radius; in brackets what an assumption changes.
std::string headline_of(const Ladder& ladder);

/// Headline, a table of quantities by rungs, and what is not computed, for the terminal.
std::string ladder_text(const std::string& name, const Ladder& ladder);

///   name, headline, headline_quantity
///   mdr            value of each quantity by MDR's own model, SI units
///   mdr_off_by     of each quantity value (MDR's over the truth, less 1), uncertainty, resolved
///   fe             value, uncertainty of each quantity for the whole
///   rungs          by key: title, mdr_off_by, fe
///   interaction    of each quantity, with two rungs or more: the change of the whole less those of the rungs
///   not_computed   assumption, order
///   inputs         see inputs_json
///   at             where MDR's own model has the case: phase, poisson_ratio, radius_over_thickness, and by quantity
///   the
///                  stick ratios
nlohmann::ordered_json ladder_json(const Case& input, const Ladder& ladder);

}  // namespace fretval
