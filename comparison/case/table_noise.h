#pragma once

#include <optional>
#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// Standard deviation of the heights of a table in m, to one digit, if its image falls because they scatter, as that of
/// a rough table does which is interpolated. Empty: the image does not fall, or does so whatever the noise. The noise
/// is estimated by the median residual of a row from the cubic through its four neighbours. It explains the falls if
/// there is a convex fit (mdr/profiles/convex_fit.h) within this noise, or within 1.5 times of it.
std::optional<double> noise_behind_falls(const Case::Indenter& indenter);

/// What a user is told of noise: "it looks like noise of 0.2 um: set Indenter / Table noise = 0.2 um, …"
std::string noise_text(double noise);

}  // namespace fretval
