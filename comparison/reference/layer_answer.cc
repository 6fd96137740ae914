#include "comparison/reference/layer_answer.h"

#include "comparison/reference/springs_as_asked.h"
#include "mdr/layer/coupled_path.h"
#include "mdr/layer/coupled_response.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/layer/layer_limiting_profile.h"
#include "mdr/layer/layer_limiting_state.h"

namespace fretval {
namespace {

mdr::SteppedForcedResponse stepped_on_layer(const MdrCase& mdr, const mdr::Prescribed& prescribed, int n_ramp_periods,
                                            int times) {
  return mdr::coupled_response(mdr.profile, mdr.layer.value(), mdr.body, mdr.friction_coefficient, prescribed,
                               fineness_of(mdr, mdr::SpringFineness{50, 46, n_ramp_periods, 1e-7}, times));
}

/// The contact of a viscoelastic layer reaches, as it grows, the radius of the contact with an elastic one at the same
/// indentation, which springs find under a force.
void take_radius(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped, mdr::NormalResponse& normal) {
  const auto radius_at = [&mdr](double indentation) {
    return mdr::layer_contact_at_depth(mdr.profile, mdr.layer.value(), indentation).contact_radius;
  };
  const double deepest = stepped.response.largest_indentation;
  normal.contact_radius_max = radius_at(deepest);
  normal.contact_radius_error =
      mdr.normal_force ? radius_at(deepest + stepped.error.largest_indentation) - normal.contact_radius_max : 0;
}

/// What is left to find of a normal response, over what the case asks for: under a force the radius.
double excess_of_response(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped) {
  auto normal = stepped.response.normal;
  if (!mdr.normal_force || mdr.tolerance == 0)
    return excess_of_normal_force(mdr, normal.normal_force_max, stepped.error.normal.normal_force_max);
  take_radius(mdr, stepped, normal);
  const double a = normal.contact_radius_max;
  return excess_of(mdr.tolerance, Quantity::contact_radius_max, a, normal.contact_radius_error, {a, 0, 0});
}

}  // namespace

mdr::NormalResponse layer_normal_response(const MdrCase& mdr) {
  constexpr int no_ramp = 1;  // without friction the state that repeats is the same whatever leads to it
  const auto stepped =
      refined_until_known([&](const mdr::SteppedForcedResponse& found) { return excess_of_response(mdr, found); },
                          [&](int times) { return stepped_on_layer(mdr, mdr.prescribed_normally(), no_ramp, times); });
  auto normal = stepped.response.normal;
  take_radius(mdr, stepped, normal);
  normal.normal_force_error = mdr.normal_force ? 0 : stepped.error.normal.normal_force_max;
  return normal;
}

mdr::SteppedForcedResponse layer_response(const MdrCase& mdr, int times) {
  return stepped_on_layer(mdr, mdr.prescribed(), 4, times);
}

mdr::SteppedPathForces layer_path_forces(const MdrCase& mdr, double friction_coefficient, const mdr::SampledPath& path,
                                         const mdr::PathFineness& fineness) {
  return mdr::coupled_path_forces(mdr.profile, mdr.layer.value(), mdr.body, friction_coefficient, path, fineness);
}

std::optional<mdr::LimitingState> layer_wear_state(const MdrCase& mdr, mdr::StickCriterion criterion) {
  return mdr::layer_limiting_state(mdr.profile, mdr.layer.value(), mdr.body, mdr.friction_coefficient,
                                   control_of(mdr.prescribed()), criterion);
}

std::optional<double> layer_worn_radius(const MdrCase& mdr, const std::optional<double>& shakedown_radius,
                                        double deepest) {
  if (!shakedown_radius || mdr.has_forces()) return std::nullopt;
  return mdr::layer_limiting_profile(mdr.profile, mdr.layer.value(), *shakedown_radius, deepest).outer_radius;
}

}  // namespace fretval
