#include "comparison/reference/springs_as_asked.h"

namespace fretval {

bool is_known_to(double tolerance, Quantity quantity, double value, double error, const Scales& scales) {
  constexpr double share_of_springs = 0.25;
  return error <= share_of_springs * tolerance / traits_of(quantity).strictness * scale_of(quantity, scales, value);
}

bool knows_normal_force(const MdrCase& mdr, double force, double error) {
  return mdr.tolerance == 0 || is_known_to(mdr.tolerance, Quantity::normal_force_max, force, error, {});
}

}  // namespace fretval
