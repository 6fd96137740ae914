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

bool still_settles(const std::vector<Eigen::ArrayXd>& slip_of_periods, double allowed) {
  constexpr std::size_t many_periods = 10;
  constexpr int most_rises = 1;  // springs that touch from step to step scatter
  constexpr double settled_share = 0.01;
  const std::size_t n = slip_of_periods.size();
  if (n <= many_periods) return false;
  const Eigen::ArrayXd& last = slip_of_periods.back();
  const Eigen::Index innermost =
      std::find_if(last.begin(), last.end(), [=](double slip) { return slip > allowed; }) - last.begin();
  if (innermost == last.size()) return false;
  int rises = 0;
  for (std::size_t k = n - many_periods; k < n; ++k)
    rises += slip_of_periods[k][innermost] >= slip_of_periods[k - 1][innermost];
  return rises <= most_rises &&
         last[innermost] < (1 - settled_share) * slip_of_periods[n - 1 - many_periods][innermost];
}

}  // namespace fretval::mdr
