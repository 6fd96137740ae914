#include "fem/wear/ring_widths.h"

#include <algorithm>

namespace fretval::fem {

RingWidths rings_at(const std::vector<double>& radii, double radius) {
  const auto outer = std::upper_bound(radii.begin(), radii.end(), radius), at = outer - 1;
  return {at == radii.begin() ? 0 : at[0] - at[-1], outer == radii.end() ? 0 : outer[0] - at[0]};
}

}  // namespace fretval::fem
