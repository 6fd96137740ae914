#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_answer.h"
#include "mdr/layer/layer_limiting_profile.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/wear/wear_kinetics.h"

namespace fretval {

/// A limiting profile, of a half-space or of a layer. SI units.
struct WearLimit {
  double stick_radius, maximum_indentation, outer_radius;
  double volume;                         ///< worn off up to this profile
  std::function<double(double)> height;  ///< height in m at a radius in m
};
WearLimit wear_limit(const mdr::LimitingProfile& profile);
WearLimit wear_limit(const mdr::LayerLimitingProfile& profile);

/// The profiles to which the wear of a case tends, for the stick radii of shakedown and of first slip. Where nothing
/// sticks a stick radius of a millionth of the contact radius is taken: all that the largest indentation reaches is
/// worn. Under prescribed forces the profile of shakedown is that of the limiting state, to whose largest indentation
/// wear leads, and that of first slip has the first-slip radius of the unworn contact at the same depth. Over a layer
/// both are those of the limiting states (mdr/layer/layer_limiting_state.h), whose stick radii are not those of the
/// unworn contact.
struct WearLimits {
  WearLimit shakedown, first_slip;
  /// Whether wear leads to the profile of shakedown. It does not where the stick zone grows on the way, as it does
  /// under a normal force and a prescribed tangential displacement: the deeper the indenter has sunk in, the more of it
  /// sticks, and what has been worn off before stays so. In that case the end depends on the course, and so on the law
  /// of wear. It does not either where the indenter is worn deeper somewhere from the beginning.
  bool reached = true;
};
WearLimits wear_limits(const MdrCase& mdr, const MdrAnswer& answer);

/// The course of the wear of a case by springs. Empty: over a layer, the indenter has worn before, the law is not
/// linear in the pressure, or the motion has several harmonics, other frequencies, no locked phase, a path or
/// prescribed forces, for which springs do not wear. fineness: factor on the numbers of springs and steps of
/// mdr::WearControl, by which jumps are smaller. Throws std::runtime_error where the springs do not become periodic.
std::optional<mdr::WearKinetics> wear_kinetics_of(const Case& input, const MdrCase& mdr, double n_cycles,
                                                  int fineness = 1);

/// The "wear" object of `fretval mdr --json` and result.json; SI units.
nlohmann::ordered_json to_json(const mdr::WearKinetics& kinetics);

}  // namespace fretval
