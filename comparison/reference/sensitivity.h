#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/case/case.h"

namespace fretval {

/// By how many percent a stick radius c changes with a percent of an input: d ln c / d ln x.
struct RadiusSensitivity {
  double friction;         ///< x = mu
  double relaxed_modulus;  ///< x = G'(0), the branches as they are
};

/// How both stick radii depend on friction and modulus; empty where nothing sticks.
struct Sensitivities {
  std::optional<RadiusSensitivity> first_slip = {}, shakedown = {};
};

/// From MDR's closed form, by central differences of a ten-thousandth, which leaves 1e-7 of them. Empty where there is
/// no closed form: prescribed forces, paths, layers, motions in two directions, worn indenters; or no one full circle
/// of contact.
std::optional<Sensitivities> sensitivities(const Case& input);

/// As result.json has them: by stick radius, "friction_coefficient" and "relaxed_modulus"; null where nothing sticks.
nlohmann::ordered_json to_json(const Sensitivities& sensitivities);

}  // namespace fretval
