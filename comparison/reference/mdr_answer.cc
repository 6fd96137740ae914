#include "comparison/reference/mdr_answer.h"

#include <nlohmann/json.hpp>

#include "comparison/support/json.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

mdr::NormalResponse mdr_normal_response(const MdrCase& scene) {
  if (scene.limiting)
    return mdr::periodic_normal_response([worn = *scene.limiting](double x) { return mdr::transform(worn, x); },
                                         scene.limiting->stick_radius, scene.body, scene.motion,
                                         mdr::transform_kinks(scene.limiting->unworn));
  const double outer = mdr::inverse_transform(scene.profile, mdr::maximum_indentation(scene.motion));
  return mdr::periodic_normal_response([profile = scene.profile](double x) { return mdr::transform(profile, x); },
                                       outer, scene.body, scene.motion, mdr::transform_kinks(scene.profile));
}

std::optional<mdr::LimitingProfile> worn_profile(const MdrCase& scene, const std::optional<double>& shakedown_radius) {
  if (scene.limiting || !shakedown_radius) return scene.limiting;
  return mdr::limiting_profile(scene.profile, *shakedown_radius, mdr::maximum_indentation(scene.motion));
}

nlohmann::ordered_json to_json(const MdrAnswer& answer) {
  return {{"modulus_ratio", answer.modulus_ratio},
          {"contact_radius_max", or_null(answer.contact_radius_max)},
          {"stick_radius_first_slip", or_null(answer.stick_radius_first_slip)},
          {"stick_radius_shakedown", or_null(answer.stick_radius_shakedown)},
          {"worn_radius", or_null(answer.worn_radius)},
          {"normal_force_max", or_null(answer.normal_force_max)}};
}

MdrAnswer mdr_answer(const MdrCase& scene, const mdr::NormalResponse& normal) {
  MdrAnswer answer{};
  answer.modulus_ratio = mdr::modulus_ratio(scene.body, mdr::angular_frequency(scene.motion.normal_frequency));
  answer.contact_radius_max = normal.contact_radius_max;
  answer.normal_force_max = normal.normal_force_max;
  const auto radii = mdr::stick_radii(scene.profile, scene.body, scene.friction_coefficient, scene.motion);
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  if (const auto worn = worn_profile(scene, radii.shakedown)) answer.worn_radius = worn->outer_radius;
  return answer;
}

}  // namespace fretval
