#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "comparison/accuracy/wear_proof.h"

namespace fretval {

const char* name_of(fem::WearEnd end);

/// Lists of the values at all points of a course; SI units.
nlohmann::ordered_json course_json(const fem::WearCourse& course, const Units& units);

/// "fe.wear" of result.json: the course with the same keys as that of the reference (`cycles`, `volume`, `deepest`,
/// `friction_work`, `contact_radius`, `stick_radius`; the final `worn_depth` over `r`), and `law`, `end`,
/// `distance_to_limit`, `pressed_outside`, `zones`, what it cost. SI units.
nlohmann::ordered_json to_json(const ProvedWear& wear, const Units& units);

/// worn_profile.csv: radius and height of the worn indenter, from the centre on, as Wear / Profile and a table of an
/// indenter take it. worn_rings.csv: what each ring has lost, as Wear / Worn rings takes it. wear.csv:
/// by ring the heights at some states of the course, and the largest pressures at its start, when half of the volume
/// is worn off, and at its end. NAME-worn.prm: the
/// case that goes on from there, not for a point of a sweep.
void write_wear(const ProvedWear& wear, const Case& input, const Units& units, const std::filesystem::path& folder);

}  // namespace fretval
