#include "comparison/reference/sensitivity.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/quantities/quantity.h"
#include "comparison/reference/incompressible_case.h"
#include "comparison/reference/mdr_case.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {
namespace {

constexpr double step = 1e-4;

bool has_closed_form(const Case& input) {
  const auto& motion = input.motion;
  return input.body.shape != Case::Body::Shape::layer && input.wear == Case::Wear::unworn && !motion.path &&
         !motion.normal_force && !motion.tangential_force && !motion.moves_across();
}

/// Where both have the radius.
std::optional<double> slope(const std::optional<double>& below, const std::optional<double>& above) {
  if (!below || !above || !(*below > 0) || !(*above > 0)) return std::nullopt;
  return std::log(*above / *below) / (2 * step);
}

std::optional<RadiusSensitivity> both(const std::optional<double>& friction, const std::optional<double>& modulus) {
  if (!friction || !modulus) return std::nullopt;
  return RadiusSensitivity{*friction, *modulus};
}

nlohmann::ordered_json to_json(const std::optional<RadiusSensitivity>& one) {
  if (!one) return nullptr;
  return {{"friction_coefficient", one->friction}, {"relaxed_modulus", one->relaxed_modulus}};
}

}  // namespace

std::optional<Sensitivities> sensitivities(const Case& input) {
  if (!has_closed_form(input)) return std::nullopt;
  const auto incompressible = incompressible_case(input).input;
  const auto profile = any_profile_of(incompressible.indenter);
  if (!mdr::falls_of_image(profile).empty()) return std::nullopt;
  const auto motion = harmonic_motion_of(incompressible.motion);
  const auto radii = [&](double friction, double modulus) {
    auto elastomer = incompressible.elastomer;
    elastomer.relaxed_modulus *= modulus;
    return mdr::stick_radii(profile, rheology_of(elastomer), friction * incompressible.friction_coefficient, motion);
  };
  const double less = std::exp(-step), more = std::exp(step);
  const auto of_less_friction = radii(less, 1), of_more_friction = radii(more, 1), of_softer = radii(1, less),
             of_stiffer = radii(1, more);
  return Sensitivities{both(slope(of_less_friction.first_slip, of_more_friction.first_slip),
                            slope(of_softer.first_slip, of_stiffer.first_slip)),
                       both(slope(of_less_friction.shakedown, of_more_friction.shakedown),
                            slope(of_softer.shakedown, of_stiffer.shakedown))};
}

nlohmann::ordered_json to_json(const Sensitivities& sensitivities) {
  return {{name_of(Quantity::stick_radius_first_slip), to_json(sensitivities.first_slip)},
          {name_of(Quantity::stick_radius_shakedown), to_json(sensitivities.shakedown)}};
}

}  // namespace fretval
