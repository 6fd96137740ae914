#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/wear_limit.h"
#include "mdr/wear/wear_kinetics.h"

namespace fretval {

/// The profiles that the wear of a case tends to, for either stick radius. Where nothing sticks, that of a stick radius
/// of a millionth of the contact radius: all that the largest indentation reaches is worn. Under prescribed forces that
/// of the limiting state, whose largest indentation wear leads to, and of the first-slip radius of the unworn contact
/// at the same depth. Over a layer those of the limiting states (mdr/layer/layer_limiting_state.h), whose stick radii
/// are not those of the unworn contact.
struct WearLimits {
  WearLimit shakedown, first_slip;
  /// Whether wear leads to that of shakedown. Not where the stick zone grows on the way, as it does under a normal
  /// force and a prescribed tangential displacement: the deeper the indenter has sunk in, the more of it sticks, and
  /// what has been worn off before stays so. Then the end depends on the course, and so on the law of wear. Nor where
  /// an indenter begins that is worn deeper somewhere.
  bool reached = true;
};
WearLimits wear_limits(const MdrCase& mdr, const MdrAnswer& answer);

/// The course of the wear of a case by springs. Empty: over a layer, the indenter has worn before, the law is not
/// linear in the pressure, or the motion has several harmonics, other frequencies, no locked phase, a path or
/// prescribed forces, which they do not have. fineness: by which there are more springs and steps, and smaller jumps,
/// than mdr::WearControl has. Throws std::runtime_error where the springs do not become periodic.
std::optional<mdr::WearKinetics> wear_kinetics_of(const Case& input, const MdrCase& mdr, double n_cycles,
                                                  int fineness = 1);

/// The "wear" object of `fretval mdr --json` and result.json; SI units.
nlohmann::ordered_json to_json(const mdr::WearKinetics& kinetics);

}  // namespace fretval
