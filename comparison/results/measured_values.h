#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/case/case.h"

namespace fretval {

/// "measured" of result.json: value and uncertainty of each quantity that the rig has measured, the values of both
/// methods, and their differences from it. From loops come the largest forces and the work in a loop of F_x over u_x.
/// fe, mdr: their objects in result.json. SI units. Null: nothing was measured.
nlohmann::ordered_json measured_json(const Case& input, const nlohmann::ordered_json& fe,
                                     const nlohmann::ordered_json& mdr);

}  // namespace fretval
