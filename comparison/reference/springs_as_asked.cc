#include "comparison/reference/springs_as_asked.h"

namespace fretval {

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

bool is_known_to(double tolerance, Quantity quantity, double value, double error, const Scales& scales) {
  constexpr double share_of_springs = 0.25;
  return error <= share_of_springs * tolerance / traits_of(quantity).strictness * scale_of(quantity, scales, value);
}

bool knows_normal_force(const MdrCase& mdr, double force, double error) {
  return mdr.tolerance == 0 || is_known_to(mdr.tolerance, Quantity::normal_force_max, force, error, {});
}

}  // namespace fretval
