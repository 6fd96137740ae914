#include "fem/stick_zone/slip_decay.h"

#include <cmath>

namespace fretval::fem {

std::vector<double> slip_decay(const FrictionHistory& history, Eigen::Index n_inside) {
  std::vector<double> decay;
  if (n_inside == 0 || !(history.amplitude > 0)) return decay;
  for (const auto& slip : history.slip_of_periods) decay.push_back(slip.head(n_inside).maxCoeff() / history.amplitude);
  return decay;
}

std::optional<DecayFactor> decay_factor(const FrictionHistory& history, Eigen::Index n_inside, int n_ramp) {
  constexpr double roundoff = 1e-10;
  const auto slip = slip_decay(history, n_inside);
  if (history.jumped) return std::nullopt;
  auto last = slip.size();
  while (last > 0 && !(slip[last - 1] > roundoff)) --last;
  if (last < static_cast<std::size_t>(n_ramp) + 4) return std::nullopt;
  const double now = slip[last - 1] / slip[last - 2], before = slip[last - 2] / slip[last - 3];
  if (!(now < 1 && before < 1 && slip[last - 3] > 0)) return std::nullopt;
  const double root = std::sqrt(now);
  return DecayFactor{now, std::abs(now - before) * root / (1 - root)};
}

}  // namespace fretval::fem
