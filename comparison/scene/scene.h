#pragma once

#include <optional>
#include <string>

#include "comparison/case/case.h"
#include "comparison/scene/from_mdr.h"
#include "mdr/motion/harmonic_motion.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/rheology.h"

namespace fretval {

// A case in numbers, which both methods are made from: heights of the indenter, moduli in time and the motion. SI
// units, angles in radians. Nothing here depends on how either method answers.

/// Of a profile that MDR holds for. Tables are read here: InputError with file and line.
mdr::Profile profile_of(const Case::Indenter& indenter);
/// A profile whose image may fall, as that of a table, which profile_of refuses because MDR does not hold for it.
mdr::Profile any_profile_of(const Case::Indenter& indenter);
/// "its one-dimensional image g(x) falls for x = 1e-4 to 2e-4 m"; empty: it rises.
std::string falls_text(const mdr::Profile& profile);

mdr::Rheology rheology_of(const Case::Elastomer& elastomer);
/// The body in time: a fractional one is approximated from a tenth of its lowest frequency of motion to a thousand
/// times it.
mdr::PronyBody body_in_time(const Case& input);

/// As in the case file. A force stands in the place of the displacement.
mdr::HarmonicMotion harmonic_motion_of(const Case::Motion& motion);
/// Without still harmonics; time 0: an instant of largest indentation or, where it is prescribed, normal force. An
/// amplitude that the case leaves to the limiting profile (shakedown) is that of the limiting indenter; 0: without it.
mdr::HarmonicMotion motion_of_case(const Case::Motion& motion,
                                   const std::optional<LimitingIndenter>& limiting = std::nullopt);

/// Oscillations in the longest cycle that either method steps through as it is.
constexpr int longest_cycle = 200;

}  // namespace fretval
