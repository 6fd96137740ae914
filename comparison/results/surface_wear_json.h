#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "comparison/accuracy/surface_wear_proof.h"

namespace fretval {

/// The "surface_wear" object of result.json, see docs/results.md; SI units.
nlohmann::ordered_json to_json(const ProvedSurfaceWear& wear, const Units& units);

/// worn_surface.csv: at each point of rings and angles the height of the indenter before wear and at its end, and the
/// largest pressure of the last cycle.
void write_surface_wear(const ProvedSurfaceWear& wear, const Units& units, const std::filesystem::path& folder);

}  // namespace fretval
