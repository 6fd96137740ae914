#pragma once

#include "comparison/reference/mdr_case.h"
#include "mdr/springs/path_response.h"
#include "mdr/stick/limiting_state.h"

namespace fretval {

/// mdr_normal_response over a layer (MdrCase::layer).
mdr::NormalResponse layer_normal_response(const MdrCase& mdr);

/// The response of springs that the layer couples to an unworn indenter that oscillates. times: factor on the usual
/// numbers of springs and steps. Throws mdr::GrossSlip, and otherwise as mdr::coupled_response.
mdr::SteppedForcedResponse layer_response(const MdrCase& mdr, int times);

/// mdr::path_forces over a layer.
mdr::SteppedPathForces layer_path_forces(const MdrCase& mdr, double friction_coefficient, const mdr::SampledPath& path,
                                         const mdr::PathFineness& fineness);

/// Limiting state to which the wear of a rig on a layer leads: one harmonic in each direction, of equal frequencies
/// unless the phase is not locked. Empty: no contact carries the motion without slip. Throws std::invalid_argument for
/// other motions.
std::optional<mdr::LimitingState> layer_wear_state(const MdrCase& mdr, mdr::StickCriterion criterion);

/// MdrAnswer::worn_radius over a layer, m; deepest: largest indentation, m. Empty: nothing sticks, or a force is
/// prescribed, so that the limiting state has another indentation.
std::optional<double> layer_worn_radius(const MdrCase& mdr, const std::optional<double>& shakedown_radius,
                                        double deepest);

}  // namespace fretval
