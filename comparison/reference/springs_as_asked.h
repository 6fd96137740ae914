#pragma once

#include "comparison/quantities/quantity.h"
#include "comparison/reference/mdr_case.h"
#include "comparison/support/stopwatch.h"
#include "mdr/springs/path_data.h"

namespace fretval {

/// How springs come to know something as well as is asked: twice as many at a time, from the usual numbers of springs
/// and steps to eight times these.
class SpringRefinement {
 public:
  /// Whether twice as many are to be asked. excess: error of the last ones over what is allowed. Not where it is 1 at
  /// most, nor where there is no hope: by as much as it has fallen at best, or to a half, it would not fall to 1 with
  /// as many as may be asked. Tells the log before what takes long.
  bool goes_on(double excess);
  [[nodiscard]] int times() const { return times_; }  ///< the usual numbers

 private:
  int times_ = 1;
  double excess_before_ = 0, best_gain_ = 2;
  Stopwatch watch_ = {};
};

/// What springs say, with the fewest that know it as well as is asked, or as many as there is hope for
/// (SpringRefinement). with(times): the answer of `times` the usual numbers; excess: of an answer.
template <class Excess, class With>
auto refined_until_known(const Excess& excess, const With& with) {
  SpringRefinement refinement;
  while (true)
    if (auto answer = with(refinement.times()); !refinement.goes_on(excess(answer))) return answer;
}

/// Springs and steps of a case: `times` the usual numbers, or so many times fewer as it asks for (coarser_springs).
mdr::SpringFineness fineness_of(const MdrCase& mdr, mdr::SpringFineness usual, int times);
mdr::PathFineness fineness_of(const MdrCase& mdr, mdr::PathFineness usual, int times);

/// Error of a value by springs over what is allowed, a quarter of a tolerance of the case; value, error: SI units.
double excess_of(double tolerance, Quantity quantity, double value, double error, const Scales& scales);

/// That of the largest normal force, over what the case asks for; 0 where it asks for nothing. force, error: N.
double excess_of_normal_force(const MdrCase& mdr, double force, double error);

}  // namespace fretval
