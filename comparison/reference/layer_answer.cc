#include "comparison/reference/layer_answer.h"

#include <algorithm>

#include "comparison/reference/cycle_of_springs.h"
#include "mdr/layer/coupled_response.h"
#include "mdr/layer/layer_contact.h"
#include "mdr/layer/layer_limiting_profile.h"

namespace fretval {
namespace {

constexpr mdr::SpringFineness usual{100, 90, 10, 1e-7};

mdr::SteppedForcedResponse stepped_on_layer(const MdrCase& mdr, const mdr::Prescribed& prescribed, int times) {
  auto fineness = usual;
  fineness.n_springs *= times;
  fineness.steps_per_oscillation *= times;
  return mdr::coupled_response(mdr.profile, mdr.layer.value(), mdr.body, mdr.friction_coefficient, prescribed,
                               fineness);
}

/// Radius of the contact of the elastic layer, which that of a viscoelastic one reaches as it grows.
double contact_radius_at(const MdrCase& mdr, double indentation) {
  return mdr::layer_contact_at_depth(mdr.profile, mdr.layer.value(), indentation).contact_radius;
}

}  // namespace

mdr::NormalResponse layer_normal_response(const MdrCase& mdr) {
  auto prescribed = mdr.prescribed();
  prescribed.motion.tangential.clear();
  prescribed.motion.phase_locked = true;
  prescribed.tangential_force = false;
  const auto [response, error] = stepped_on_layer(mdr, prescribed, 2);
  auto normal = response.normal;
  normal.contact_radius_max = contact_radius_at(mdr, response.largest_indentation);
  normal.normal_force_error = mdr.normal_force ? 0 : error.normal.normal_force_max;
  return normal;
}

MdrAnswer layer_answer(const MdrCase& mdr, const mdr::NormalResponse& normal, int times) {
  MdrAnswer answer{};
  answer.contact_radius_max = normal.contact_radius_max;
  answer.normal_force_max = normal.normal_force_max;
  answer.normal_force_error = normal.normal_force_error;
  answer.axis_pressure = normal.axis_pressure;
  mdr::SteppedForcedResponse stepped;
  try {
    stepped = stepped_on_layer(mdr, mdr.prescribed(), times);
  } catch (const mdr::GrossSlip& slip) {
    answer.gross_slip = slip.amplitude;
    return answer;
  }
  const auto& [response, error] = stepped;
  answer.cycle = cycle_of_springs(mdr, stepped, normal.normal_force_max);
  const auto radii = mdr::depths_as_radii(mdr.profile, response.depths);
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  const double deepest = response.largest_indentation;
  answer.stepping_error =
      std::max({error.depths.first_slip, error.depths.shakedown, error.largest_indentation}) / deepest;
  if (mdr.normal_force) answer.indentation_max = deepest;
  if (mdr.tangential_force && mdr.has_period()) {
    answer.tangential_amplitude = response.tangential_amplitude;
    answer.stepping_error = std::max(answer.stepping_error, error.tangential_amplitude / response.tangential_amplitude);
  }
  if (radii.shakedown && !mdr.has_forces())
    answer.worn_radius =
        mdr::layer_limiting_profile(mdr.profile, mdr.layer.value(), *radii.shakedown, deepest).outer_radius;
  return answer;
}

}  // namespace fretval
