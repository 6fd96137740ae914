#pragma once

#include <string>
#include <vector>

#include "comparison/case/case.h"

namespace fretval {

/// Warnings about a path that is passed once whose first row, in which the body rests without a tangential force, is
/// not what the rows behind it lead to, by more than the tolerance times the range of its column: the whole answer
/// moves with it. In columns of 32 rows or more the first row is compared with the line through the next four: a
/// warning is given if it is farther from that line than the tolerance and than three times the median of the other
/// rows, or if all rows scatter by more than the tolerance. There is none for a path that repeats, which rests at its
/// mean, for one that begins with a touch, which does not rest in contact, and for one with fewer rows than its record,
/// which has the error of its first row in the bars (record.h).
std::vector<std::string> noisy_start(const Case::Path& path, double tolerance);

}  // namespace fretval
