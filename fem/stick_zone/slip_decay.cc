#include "fem/stick_zone/slip_decay.h"

namespace fretval::fem {

std::vector<double> slip_decay(const FrictionHistory& history, Eigen::Index n_inside) {
  std::vector<double> decay;
  if (n_inside == 0 || !(history.amplitude > 0)) return decay;
  for (const auto& slip : history.slip_of_periods) decay.push_back(slip.head(n_inside).maxCoeff() / history.amplitude);
  return decay;
}

}  // namespace fretval::fem
