#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/case/case.h"

namespace fretval {

/// Relative change of a stick radius c by a relative change of an input x: d ln c / d ln x.
struct RadiusSensitivity {
  double friction;         ///< x = mu
  double relaxed_modulus;  ///< x = G'(0), the branches as they are
};

/// Sensitivities of the two stick radii to friction and modulus; empty where nothing sticks.
struct Sensitivities {
  std::optional<RadiusSensitivity> first_slip = {}, shakedown = {};
};

/// Sensitivities by MDR's closed form, from central differences of a ten-thousandth, with a relative error of 1e-7.
/// Empty where there is no closed form: prescribed forces, paths, layers, motions in two directions, worn indenters; or
/// no one full circle of contact.
std::optional<Sensitivities> sensitivities(const Case& input);

/// The sensitivities as in result.json: by stick radius, "friction_coefficient" and "relaxed_modulus"; null where
/// nothing sticks.
nlohmann::ordered_json to_json(const Sensitivities& sensitivities);

}  // namespace fretval
