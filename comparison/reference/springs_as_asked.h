#pragma once

#include "comparison/reference/mdr_case.h"

namespace fretval {

/// What springs may err by, over the tolerance of a case.
inline constexpr double enough_of_springs = 0.25;

/// What springs say, with the fewest that know it as well as is asked: the usual numbers of springs and steps, or up to
/// eight times as many. with(times): the answer of `times` the usual numbers.
template <class IsKnown, class With>
auto refined_until_known(const IsKnown& is_known, const With& with) {
  constexpr int most_times = 8;
  for (int times = 1;; times *= 2)
    if (auto answer = with(times); times == most_times || is_known(answer)) return answer;
}

/// Whether the largest normal force is known as well as the case asks for; force, error: N.
bool knows_normal_force(const MdrCase& mdr, double force, double error);

}  // namespace fretval
