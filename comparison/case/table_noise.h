#pragma once

#include <optional>
#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Standard deviation of the heights of a table in m, if its image falls because they scatter, as a rough table does
/// that is interpolated; rounded to one digit. Empty: the image does not fall, or does so whatever the noise. The noise
/// is that of the residuals of parabolas through five neighbours each, by their median; whether it explains the falls,
/// a convex fit within it tells (mdr/profiles/convex_fit.h), within half of that again if the first one is too close.
std::optional<double> noise_behind_falls(const Case::Indenter& indenter);

/// "it looks like noise of 0.2 um: set Indenter / Table noise = 0.2 um, …"
std::string noise_text(double noise);

}  // namespace fretval
