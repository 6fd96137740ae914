#include "comparison/reference/mdr_wear.h"

#include <nlohmann/json.hpp>
#include <vector>

#include "mdr/profiles/profile.h"

namespace fretval {

WearLimits wear_limits(const MdrCase& mdr, const MdrAnswer& answer) {
  constexpr double almost_none = 1e-6;
  const double deepest = mdr.has_forces() ? mdr::maximum_indentation(mdr.limiting_state->motion)
                         : mdr.path       ? deepest_indentation(mdr)
                                          : mdr::maximum_indentation(mdr.motion);
  const double least = almost_none * mdr::inverse_transform(mdr.profile, deepest);
  const auto limit = [&](const std::optional<double>& stick_radius) {
    return mdr::limiting_profile(mdr.profile, stick_radius.value_or(least), deepest);
  };
  constexpr double roundoff = 1e-6;
  const bool grows =
      mdr.has_forces() && mdr.limiting_state->stick_radius > (1 + roundoff) * answer.stick_radius_shakedown.value_or(0);
  return {limit(mdr.has_forces() ? mdr.limiting_state->stick_radius : answer.stick_radius_shakedown),
          limit(answer.stick_radius_first_slip), !grows};
}

std::optional<mdr::WearKinetics> wear_kinetics_of(const Case& input, const MdrCase& mdr, double n_cycles,
                                                  int fineness) {
  const auto& wear = input.wear_kinetics.value();
  const auto motion = mdr::one_harmonic_each(mdr.motion);
  if (wear.has_worn_before() || mdr.path || wear.law == Case::WearLaw::power || mdr.has_forces() || !motion ||
      !motion->phase || motion->normal_frequency != motion->tangential_frequency)
    return std::nullopt;
  const double coefficient =
      wear.law == Case::WearLaw::energy ? mdr.friction_coefficient * wear.coefficient : wear.coefficient;
  mdr::WearControl control{coefficient, n_cycles};
  control.n_springs *= fineness;
  control.steps_per_cycle *= fineness;
  control.largest_jump /= fineness;
  return mdr::wear_kinetics(mdr.profile, mdr.body, mdr.friction_coefficient, *motion, control);
}

nlohmann::ordered_json to_json(const mdr::WearKinetics& kinetics) {
  nlohmann::ordered_json json;
  for (const auto& point : kinetics.curve) {
    json["cycles"].push_back(point.cycles);
    json["volume"].push_back(point.volume);
    json["deepest"].push_back(point.deepest);
    json["friction_work"].push_back(point.friction_work);
    json["contact_radius"].push_back(point.contact_radius);
    json["stick_radius"].push_back(point.stick_radius);
  }
  const auto list = [](const Eigen::ArrayXd& a) { return std::vector<double>(a.data(), a.data() + a.size()); };
  json["r"] = list(kinetics.radius);
  json["worn_depth"] = list(kinetics.worn_depth);
  return json;
}

}  // namespace fretval
