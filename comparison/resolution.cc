#include "comparison/resolution.h"

namespace fretval {

Resolution resolution_for(double tolerance) {
  if (tolerance >= 1e-2) return {48, 3, 0.15, 25, 48, 8, 1e-5};
  if (tolerance >= 1e-3) return {128, 3, 0.15, 25, 120, 10, 1e-6};
  return {256, 3, 0.15, 25, 180, 12, 1e-7};
}

}  // namespace fretval
