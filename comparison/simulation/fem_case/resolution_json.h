#pragma once

#include <nlohmann/json_fwd.hpp>

#include "comparison/simulation/fem_case/resolution.h"

namespace fretval {

/// elements_per_radius, degree, growth, far_radius, steps_per_cycle, ramp_cycles, periodicity; focus if there is one.
nlohmann::ordered_json resolution_json(const Resolution& resolution);

/// Inner and outer radius and ring.
nlohmann::ordered_json focus_json(const Focus& focus);

}  // namespace fretval
