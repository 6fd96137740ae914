#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Standard deviation of the heights of a table in m, to one digit, if its image falls because they scatter, as that of
/// a rough table does which is interpolated. Empty: the image does not fall, or does so whatever the noise. The noise
/// is estimated by the median residual of a row from the cubic through its four neighbours. It explains the falls if
/// there is a convex fit (mdr/profiles/convex_fit.h) within this noise, or within 1.5 times of it.
std::optional<double> noise_behind_falls(const Case::Indenter& indenter);

/// What a user is told of noise: "it looks like noise of 0.2 um: set Indenter / Table noise = 0.2 um, …"
std::string noise_text(double noise);

/// Warnings about a path that is passed once whose first row, in which the body rests without a tangential force, is
/// not what the rows behind it lead to, by more than the tolerance times the range of its column: the whole answer
/// moves with it. In columns of 32 rows or more the first row is compared with the line through the next four: a
/// warning is given if it is farther from that line than the tolerance and than three times the median of the other
/// rows, or if all rows scatter by more than the tolerance. There is none for a path that repeats, which rests at its
/// mean, for one that begins with a touch, which does not rest in contact, and for one with fewer rows than its record,
/// which has the error of its first row in the bars (path_table.h).
std::vector<std::string> noisy_start(const Case::Path& path, double tolerance);

}  // namespace fretval
