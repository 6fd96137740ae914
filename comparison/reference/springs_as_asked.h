#pragma once

#include "comparison/quantities/quantity.h"
#include "comparison/reference/mdr_case.h"
#include "mdr/springs/path_data.h"

namespace fretval {

/// What springs say, with the fewest that know it as well as is asked: the usual numbers of springs and steps, or up to
/// eight times as many. with(times): the answer of `times` the usual numbers.
template <class IsKnown, class With>
auto refined_until_known(const IsKnown& is_known, const With& with) {
  constexpr int most_times = 8;
  for (int times = 1;; times *= 2)
    if (auto answer = with(times); times == most_times || is_known(answer)) return answer;
}

/// Springs and steps of a case: `times` the usual numbers, or so many times fewer as it asks for (coarser_springs).
mdr::SpringFineness fineness_of(const MdrCase& mdr, mdr::SpringFineness usual, int times);
mdr::PathFineness fineness_of(const MdrCase& mdr, mdr::PathFineness usual, int times);

/// Whether a value by springs errs by no more than a quarter of a tolerance of the case; value, error: SI units.
bool is_known_to(double tolerance, Quantity quantity, double value, double error, const Scales& scales);

/// Whether the largest normal force is known as well as the case asks for; force, error: N.
bool knows_normal_force(const MdrCase& mdr, double force, double error);

}  // namespace fretval
