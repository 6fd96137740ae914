#include "comparison/reference/mdr_wear.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "comparison/reference/layer_answer.h"
#include "mdr/profiles/profile.h"

namespace fretval {
namespace {

/// Stick radius that is taken where nothing sticks, over the contact radius.
constexpr double almost_none = 1e-6;

WearLimits limits_on_layer(const MdrCase& mdr, const MdrAnswer& answer) {
  const auto limit = [&](mdr::StickCriterion criterion, double deepest) {
    const auto state = layer_wear_state(mdr, criterion);
    const double most = unworn_radius_at(mdr, deepest), c = state ? state->stick_radius : almost_none * most;
    return wear_limit(mdr::layer_limiting_profile(mdr.profile, mdr.layer.value(), std::min(c, most), deepest));
  };
  const auto state = layer_wear_state(mdr, mdr::StickCriterion::shakedown);
  // Where there is no limiting state under a normal force, wear goes on for ever from the unworn contact.
  const double unworn = mdr.normal_force ? answer.indentation_max.value() : mdr::maximum_indentation(mdr.motion);
  const double deepest = state ? mdr::maximum_indentation(state->motion) : unworn;
  const double uncertain = std::max(1e-6, 10 * answer.stepping_error);
  const bool grows = state && state->stick_radius > (1 + uncertain) * answer.stick_radius_shakedown.value_or(0);
  return {limit(mdr::StickCriterion::shakedown, deepest), limit(mdr::StickCriterion::first_slip, deepest),
          !grows && (state || !mdr.has_forces())};
}

template <class Profile>
WearLimit limit_of(const Profile& profile) {
  return {profile.stick_radius, profile.maximum_indentation, profile.outer_radius, mdr::worn_volume(profile),
          [profile](double r) { return mdr::shape(profile, r); }};
}

}  // namespace

WearLimits wear_limits(const MdrCase& mdr, const MdrAnswer& answer) {
  if (mdr.layer) return limits_on_layer(mdr, answer);
  const double deepest = mdr.has_forces() ? mdr::maximum_indentation(mdr.limiting_state->motion)
                         : mdr.path       ? deepest_indentation(mdr)
                                          : mdr::maximum_indentation(mdr.motion);
  const double least = almost_none * mdr::inverse_transform(mdr.profile, deepest);
  const auto limit = [&](const std::optional<double>& stick_radius) {
    return wear_limit(mdr::limiting_profile(mdr.profile, stick_radius.value_or(least), deepest));
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
  if (mdr.layer || wear.has_worn_before() || mdr.path || wear.law == Case::WearLaw::power || mdr.has_forces() ||
      !motion || !motion->phase || motion->normal_frequency != motion->tangential_frequency)
    return std::nullopt;
  // Slip is longer by mdr.displacement here than in the body of the case.
  const double coefficient =
      (wear.law == Case::WearLaw::energy ? mdr.friction_coefficient * wear.coefficient : wear.coefficient) /
      mdr.displacement;
  mdr::WearControl control{coefficient, n_cycles};
  control.n_springs *= fineness;
  control.steps_per_cycle *= fineness;
  control.largest_jump /= fineness;
  auto kinetics = mdr::wear_kinetics(mdr.profile, mdr.body, mdr.friction_coefficient, *motion, control);
  for (auto& point : kinetics.curve) point.friction_work /= mdr.displacement;
  return kinetics;
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

WearLimit wear_limit(const mdr::LimitingProfile& profile) {
  return limit_of(profile);
}

WearLimit wear_limit(const mdr::LayerLimitingProfile& profile) {
  return limit_of(profile);
}

}  // namespace fretval
