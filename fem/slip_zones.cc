#include "fem/slip_zones.h"

namespace fretval::fem {

SlipZones::SlipZones(Eigen::Index n_rings) : labels_(static_cast<std::size_t>(n_rings), never_slipped) {}

void SlipZones::update(const Eigen::VectorXd& limit, const std::vector<BoxState>& states) {
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (limit[static_cast<Eigen::Index>(i)] == 0)
      labels_[i] = free;
    else if (states[i] != BoxState::interior)
      labels_[i] = states[i] == BoxState::upper ? slipped_forward : slipped_backward;
    else if (labels_[i] == free)
      labels_[i] = touched_again;
  }
}

}  // namespace fretval::fem
