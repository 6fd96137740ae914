#include "comparison/support/cycles_until.h"

#include <algorithm>

namespace fretval {

std::optional<double> cycles_until(const std::vector<double>& slips, double least) {
  const auto last = std::find_if(slips.rbegin(), slips.rend(), [least](double slip) { return slip > least; });
  if (last == slips.rbegin() || last == slips.rend()) return std::nullopt;
  const auto next = last.base();  // the first one that is not above it any more
  return static_cast<double>(next - slips.begin()) + (*last - least) / (*last - *next);
}

}  // namespace fretval
