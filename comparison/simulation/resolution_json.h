#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparison/simulation/resolution.h"

namespace fretval {

/// Rings, degree, growth, far_radius, steps_per_cycle, ramp_cycles, periodicity; focus if there is one.
nlohmann::ordered_json resolution_json(const Resolution& resolution);

/// Inner and outer radius and ring.
nlohmann::ordered_json focus_json(const Focus& focus);

/// An object with those of each quantity.
nlohmann::ordered_json focus_json(const std::map<std::string, Focus>& focus);

}  // namespace fretval
