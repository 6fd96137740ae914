#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_answer.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/wear/wear_kinetics.h"

namespace fretval {

/// The profiles that the wear of a case tends to, for either stick radius. Where nothing sticks, that of a stick radius
/// of a millionth of the contact radius: all that the largest indentation reaches is worn.
struct WearLimits {
  mdr::LimitingProfile shakedown, first_slip;
};
WearLimits wear_limits(const MdrCase& mdr, const MdrAnswer& answer);

/// The course of the wear of a case by springs. Empty: the law is not linear in the pressure, or the motion has several
/// harmonics, other frequencies or no locked phase, which they do not have. Prescribed displacements only. Throws
/// std::runtime_error where the springs do not become periodic.
std::optional<mdr::WearKinetics> wear_kinetics_of(const Case& input, const MdrCase& mdr, double n_cycles,
                                                  int steps_per_cycle = mdr::WearControl{}.steps_per_cycle);

/// The "wear" object of `fretval mdr --json` and result.json; SI units.
nlohmann::ordered_json to_json(const mdr::WearKinetics& kinetics);

}  // namespace fretval
