#pragma once

#include <algorithm>
#include <optional>

#include "comparison/reference/mdr_values.h"
#include "mdr/motion/commensurability.h"
#include "mdr/springs/forced_response.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

/// Whether springs would take too many periods to settle, so that they are not stepped: more than 100 with a dashpot,
/// whose steps are slow, and otherwise so many that a ramp twice as long would take all periods that a history may
/// have.
bool settles_for_long(const mdr::PronyBody& body, double period);

/// The cycle of the motion that springs are stepped through; empty: there is none, see MdrAnswer::cycle.
std::optional<mdr::CommonCycle> cycle_to_step(const MdrCase& mdr);

/// Forces and works of this cycle by springs; empty: there is no such cycle.
std::optional<MdrCycle> cycle_of_springs(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped,
                                         double normal_force_max);

/// The cycle of any stepped response. tangential_way: the length of the tangential path of the indenter.
template <class Response>
MdrCycle cycle_of(const MdrCase& mdr, const Response& response, const Response& error, double normal_force_max,
                  double tangential_way) {
  const double sliding_force = mdr.friction_coefficient * normal_force_max;
  return {response.tangential_force_max,
          response.tangential_force_mean,
          response.friction_work,
          response.bulk_work,
          response.tangential_work,
          sliding_force,
          sliding_force * tangential_way,
          std::max(error.tangential_force_max, error.tangential_force_mean),
          error.friction_work + error.bulk_work,
          error.tangential_work,
          mdr.body.viscosity == 0 || mdr.is_single_pass() || mdr.cycle_tolerance};
}

/// Takes over stick radii and the largest indentation of a response that was stepped under forces, with their errors.
template <class Response>
void take_depths(const MdrCase& mdr, const mdr::StickDepths& depths, const mdr::StickDepths& depth_errors,
                 const Response& response, const Response& error, MdrAnswer& answer) {
  const auto radii = mdr::stick_radii(mdr.profile, depths);
  const auto farther = mdr::stick_radii(
      mdr.profile, {depths.first_slip + depth_errors.first_slip, depths.shakedown + depth_errors.shakedown});
  const auto off = [](const std::optional<double>& radius, const std::optional<double>& other) {
    return radius && other ? *other - *radius : 0;
  };
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  answer.stepped = {off(radii.first_slip, farther.first_slip), off(radii.shakedown, farther.shakedown), 0, 0};
  answer.stepping_error = std::max({depth_errors.first_slip, depth_errors.shakedown, error.largest_indentation}) /
                          response.largest_indentation;
  if (!mdr.normal_force) return;
  answer.indentation_max = response.largest_indentation;
  answer.stepped.indentation = error.largest_indentation;
}

/// Takes over the tangential amplitude under a prescribed tangential force; to be called after take_depths().
template <class Response>
void take_tangential_amplitude(const MdrCase& mdr, const Response& response, const Response& error, MdrAnswer& answer) {
  if (!mdr.tangential_force) return;
  answer.tangential_amplitude = response.tangential_amplitude;
  answer.stepped.tangential_amplitude = error.tangential_amplitude;
  answer.stepping_error = std::max(answer.stepping_error, error.tangential_amplitude / response.tangential_amplitude);
}

}  // namespace fretval
