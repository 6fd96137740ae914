#include "comparison/reference/springs_as_asked.h"

#include "comparison/quantities/quantity.h"

namespace fretval {

bool knows_normal_force(const MdrCase& mdr, double force, double error) {
  if (mdr.tolerance == 0) return true;
  return error <= enough_of_springs * mdr.tolerance / traits_of(Quantity::normal_force_max).strictness * force;
}

}  // namespace fretval
