#pragma once

#include <algorithm>
#include <optional>

#include "comparison/reference/mdr_values.h"
#include "mdr/motion/commensurability.h"
#include "mdr/profiles/zone_depth.h"
#include "mdr/springs/forced_response.h"
#include "mdr/springs/path_data.h"
#include "mdr/stick/stick_radius.h"

namespace fretval {

/// Whether springs would take too many periods to settle, so that they are not stepped: more than 100 with a dashpot,
/// whose steps are slow, and otherwise so many that a ramp twice as long would take all periods that a history may
/// have.
bool settles_for_long(const mdr::PronyBody& body, double period);

/// The cycle of the motion that springs are stepped through; empty: there is none, see MdrAnswer::cycle.
std::optional<mdr::CommonCycle> cycle_to_step(const MdrCase& mdr);

/// The uncertainty of a value: empty for closed forms, whose error is 0.
inline std::optional<double> if_any(double error) {
  return error > 0 ? std::optional(error) : std::nullopt;
}

/// Forces and works of this cycle by springs; empty: there is no such cycle.
std::optional<CycleReadings> cycle_of_springs(const MdrCase& mdr, const mdr::SteppedForcedResponse& stepped,
                                              double normal_force_max);

/// The cycle of a path, or of its single pass. For a pass the work inside the body is left out, as stored energy cannot
/// be told from losses.
CycleReadings cycle_along(const MdrCase& mdr, mdr::PathForces forces, mdr::PathForces error, double normal_force_max);

/// Leaves the largest tangential force out where it is not known: with a dashpot loads jump where springs touch, which
/// few springs and steps do not resolve, unless the case has a tolerance on cycles.
void leave_out_unknown_force(const MdrCase& mdr, CycleReadings& cycle);

/// Turns the cycle of an incompressible body into that of the body of the case (see incompressible_case), whose
/// tangential displacements are over `displacement`.
void divide_works(double displacement, CycleReadings& cycle);

/// Takes over stick radii and the largest indentation of a response that was stepped, with their errors. Of an answer
/// that knows its contact radius already, which no stick radius exceeds.
template <class Response>
void take_depths(const MdrCase& mdr, const mdr::StickDepths& depths, const mdr::StickDepths& depth_errors,
                 const Response& response, const Response& error, MdrAnswer& answer) {
  const auto radius_at = [&](double depth) -> std::optional<double> {
    if (!mdr.layer) return mdr::stick_radius(mdr.profile, depth);
    const auto radius = mdr::zone_radius(mdr.profile, depth);
    return radius && answer.contact_radius_max ? std::min(*radius, *answer.contact_radius_max) : radius;
  };
  const auto radii_at = [&](double errors) {
    return mdr::StickRadii{radius_at(depths.first_slip + errors * depth_errors.first_slip),
                           radius_at(depths.shakedown + errors * depth_errors.shakedown)};
  };
  const auto radii = radii_at(0), farther = radii_at(1), nearer = radii_at(-1);
  // Without a radius nothing sticks.
  const auto off = [](const std::optional<double>& radius, const std::optional<double>& outer,
                      const std::optional<double>& inner) {
    const double known = radius.value_or(0);
    return std::max(outer.value_or(0) - known, known - inner.value_or(0));
  };
  answer.stick_radius_first_slip = radii.first_slip;
  answer.stick_radius_shakedown = radii.shakedown;
  answer.stepped = {off(radii.first_slip, farther.first_slip, nearer.first_slip),
                    off(radii.shakedown, farther.shakedown, nearer.shakedown), 0, 0};
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
