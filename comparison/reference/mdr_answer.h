#pragma once

#include <optional>

#include "comparison/reference/mdr_values.h"
#include "mdr/springs/spring_foundation.h"

namespace fretval {

/// Normal response of the spring foundation in the periodic state; depends on the normal motion alone.
mdr::NormalResponse mdr_normal_response(const MdrCase& mdr);

/// The profile in which the case wears no more: the indenter itself if it is worn already, or else the limiting
/// profile of the shakedown radius; under forces that of their limiting state. Empty: nothing sticks, and wear goes on
/// for ever; or a path.
std::optional<mdr::LimitingProfile> worn_profile(const MdrCase& mdr, const std::optional<double>& shakedown_radius);

MdrAnswer mdr_answer(const MdrCase& mdr, const mdr::NormalResponse& normal);

/// Where MDR does not hold for the profile (MdrCase::falls): the ratio of moduli alone.
MdrAnswer no_answer(const MdrCase& mdr);

/// After how many cycles from rest nothing slips any more inside the shakedown radius (see cycles_until), of transient
/// springs: some milliseconds. n_ramp: oscillations over which amplitudes rise. Empty: a worn indenter, a path, a
/// motion without a period, an elastic body, which shakes down at once, springs that do not become periodic, or nothing
/// that slips first and not in the end.
std::optional<SettlingCycles> settling_cycles(const MdrCase& mdr, const MdrAnswer& answer, int n_ramp);

/// MDR's answer and its cycle under prescribed displacements, too, for which springs are stepped: ten milliseconds
/// for what is a closed form otherwise. Springs and their steps are as many as the tolerances of the case ask for
/// (refined_until_known).
MdrAnswer mdr_answer_with_cycle(const MdrCase& mdr, const mdr::NormalResponse& normal);

}  // namespace fretval
