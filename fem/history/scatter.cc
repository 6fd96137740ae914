#include "fem/history/scatter.h"

#include <algorithm>

namespace fretval::fem {

bool Scatter::is_all(double change) {
  constexpr double largest = 1e-2;
  constexpr int many_periods = 10;
  periods_since_least_ = change < least_ ? 0 : periods_since_least_ + 1;
  least_ = std::min(least_, change);
  return change <= largest && periods_since_least_ >= many_periods;
}

}  // namespace fretval::fem
