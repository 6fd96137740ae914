#include "comparison/reference/springs_as_asked.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/support/log.h"

namespace fretval {

bool SpringRefinement::goes_on(double excess) {
  constexpr int most_times = 8;
  constexpr double patience = 10;                 // s
  const double cost_of_twice = 4 * watch_.lap();  // springs and steps
  if (times_ == most_times || excess <= 1) return false;
  if (excess_before_ > 0) {
    best_gain_ = std::max(best_gain_, excess_before_ / excess);
    if (excess > std::pow(best_gain_, std::log2(most_times / times_))) return false;
  }
  if (cost_of_twice > patience)
    log::info(fmt::format(
        "MDR's springs err by {:.2g} times what the tolerance leaves them; twice as many take about {:.0f} s", excess,
        cost_of_twice));
  excess_before_ = excess;
  times_ *= 2;
  return true;
}

mdr::SpringFineness fineness_of(const MdrCase& mdr, mdr::SpringFineness usual, int times) {
  usual.n_springs = usual.n_springs * times / mdr.coarser_springs;
  usual.steps_per_oscillation = usual.steps_per_oscillation * times / mdr.coarser_springs;
  return usual;
}

mdr::PathFineness fineness_of(const MdrCase& mdr, mdr::PathFineness usual, int times) {
  usual.n_springs = usual.n_springs * times / mdr.coarser_springs;
  usual.subdivisions *= times;
  usual.steps_per_duration /= mdr.coarser_springs;
  return usual;
}

double excess_of(double tolerance, Quantity quantity, double value, double error, const Scales& scales) {
  constexpr double share_of_springs = 0.25;
  const double allowed = share_of_springs * tolerance / traits_of(quantity).strictness;
  return error == 0 ? 0 : error / (allowed * scale_of(quantity, scales, value));
}

double excess_of_normal_force(const MdrCase& mdr, double force, double error) {
  return mdr.tolerance == 0 ? 0 : excess_of(mdr.tolerance, Quantity::normal_force_max, force, error, {});
}

}  // namespace fretval
