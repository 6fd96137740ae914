#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "comparison/verification/extremes/extremes.h"

namespace fretval {

/// An object with `summary` (scenes, agree, refused, inconclusive, fail) and `scenes`, an array with an object a scene:
/// family, value, entries (of its case file), verdict, remark, expected_refusal, refusal, second_way ("finite elements"
/// or "springs"), errors (by quantity: mdr, fe, error, bar, largest_share, tolerance), worst (the quantity of
/// worst_of), seconds, refinements, size_ratio and aspect_ratio (of the mesh). Null: what there is none of, and numbers
/// that are not finite.
nlohmann::ordered_json extremes_json(const std::vector<ExtremeRecord>& records);

}  // namespace fretval
