#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/case/case.h"

namespace fretval {

/// "measured" of result.json: of each quantity that the rig has measured value and uncertainty, those of both methods,
/// and how they differ from it. From loops come the largest forces and the work in a loop of F_x over u_x. fe, mdr:
/// their objects in result.json. SI units. Null: nothing was measured.
nlohmann::ordered_json measured_json(const Case& input, const nlohmann::ordered_json& fe,
                                     const nlohmann::ordered_json& mdr);

}  // namespace fretval
