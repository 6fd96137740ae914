#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Warnings about a path that is passed once whose first row, in which the body rests without a tangential force, is
/// not what the rows behind it lead to, by more than the tolerance times the range of its column: the whole answer
/// moves with it. Looked at are columns of 32 rows or more: the first row against the line through the next four. It is
/// farther from that than the tolerance, and three times as far as the others are by the median, or all rows scatter by
/// more than that. A path that repeats rests at its mean, one that begins with a touch does not rest in contact, and
/// one with fewer rows than its record has the error of its first row in the bars (record.h): none is looked at.
std::vector<std::string> noisy_start(const Case::Path& path, double tolerance);

}  // namespace fretval
