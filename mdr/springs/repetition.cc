#include "mdr/springs/repetition.h"

#include <algorithm>
#include <cmath>

namespace fretval::mdr {

double change_of_tractions(const SpringState& before, const SpringState& after, double mu) {
  const double scale = std::max(before.tangential_load.abs().maxCoeff(), mu * before.normal_load.maxCoeff()),
               change = std::max((after.tangential_load - before.tangential_load).abs().maxCoeff(),
                                 mu * (after.normal_load - before.normal_load).abs().maxCoeff());
  return change <= 0 ? 0 : change / scale;
}

double periodicity_of(const PronyBody& body, double periodicity, int fineness) {
  constexpr double with_a_dashpot = 1e-4;
  return body.viscosity > 0 ? std::max(periodicity, with_a_dashpot / std::pow(fineness, 4)) : periodicity;
}

bool Repetition::reached(double change) {
  constexpr double largest_of_jumps = 1e-2;
  constexpr int many_periods = 10;
  periods_since_least_ = change < least_ ? 0 : periods_since_least_ + 1;
  least_ = std::min(least_, change);
  return change <= periodicity_ || (jumps_ && change <= largest_of_jumps && periods_since_least_ >= many_periods);
}

}  // namespace fretval::mdr
