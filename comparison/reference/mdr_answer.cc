#include "comparison/reference/mdr_answer.h"

#include <nlohmann/json.hpp>

#include "comparison/support/json.h"
#include "mdr/springs/stepped_response.h"
#include "mdr/stick/shakedown_amplitude.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

mdr::NormalResponse mdr_normal_response(const MdrCase& mdr) {
  const auto response = [&mdr](const std::function<double(double)>& g, double outer) {
    const auto& [indentation, normal, tangential, locked] = mdr.motion;
    if (normal.size() > 1) return mdr::stepped_normal_response(g, outer, mdr.body, mdr.motion).response;
    const auto& [amplitude, frequency, phase] = normal.front();
    return mdr::periodic_normal_response(g, outer, mdr.body, {indentation, amplitude, 0, frequency, frequency, {}},
                                         mdr::transform_kinks(mdr.profile));
  };
  if (mdr.limiting)
    return response([worn = *mdr.limiting](double x) { return mdr::transform(worn, x); }, mdr.limiting->stick_radius);
  return response([profile = mdr.profile](double x) { return mdr::transform(profile, x); },
                  mdr::inverse_transform(mdr.profile, mdr::maximum_indentation(mdr.motion)));
}

std::optional<mdr::LimitingProfile> worn_profile(const MdrCase& mdr, const std::optional<double>& shakedown_radius) {
  if (mdr.limiting || !shakedown_radius) return mdr.limiting;
  return mdr::limiting_profile(mdr.profile, *shakedown_radius, mdr::maximum_indentation(mdr.motion));
}

nlohmann::ordered_json to_json(const MdrAnswer& answer) {
  return {{"modulus_ratio", answer.modulus_ratio},
          {"contact_radius_max", or_null(answer.contact_radius_max)},
          {"stick_radius_first_slip", or_null(answer.stick_radius_first_slip)},
          {"stick_radius_shakedown", or_null(answer.stick_radius_shakedown)},
          {"worn_radius", or_null(answer.worn_radius)},
          {"normal_force_max", or_null(answer.normal_force_max)},
          {"limiting_amplitude", or_null(answer.limiting_amplitude)}};
}

bool MdrAnswer::wears_no_more() const {
  constexpr double roundoff = 1e-9;  // of the amplitude whose stick radius is asked for
  return stick_radius_shakedown && *stick_radius_shakedown >= (1 - roundoff) * contact_radius_max.value();
}

MdrAnswer mdr_answer(const MdrCase& mdr, const mdr::NormalResponse& normal) {
  MdrAnswer answer{};
  answer.modulus_ratio = mdr::modulus_ratio(mdr.body, mdr::angular_frequency(mdr.motion.normal.front().frequency));
  answer.contact_radius_max = normal.contact_radius_max;
  answer.normal_force_max = normal.normal_force_max;
  const auto one_each = mdr::one_harmonic_each(mdr.motion);
  const auto radii_on = [&](const auto& profile) {
    return one_each ? mdr::stick_radii(profile, mdr.body, mdr.friction_coefficient, *one_each)
                    : mdr::stick_radii(profile, mdr.body, mdr.friction_coefficient, mdr.motion);
  };
  const auto radii = mdr.limiting ? radii_on(*mdr.limiting) : radii_on(mdr.profile);
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  if (mdr.limiting && one_each && one_each->tangential_amplitude > 0)
    answer.limiting_amplitude =
        mdr::tangential_amplitude_for_shakedown(mdr.body, mdr.friction_coefficient, *one_each,
                                                mdr::transform(mdr.profile, mdr.limiting->stick_radius))
            .value_or(0) /
        one_each->tangential_amplitude;
  if (const auto worn = worn_profile(mdr, radii.shakedown)) answer.worn_radius = worn->outer_radius;
  return answer;
}

}  // namespace fretval
