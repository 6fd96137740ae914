#include "fem/ring_contact/slip_zones.h"

namespace fretval::fem {
namespace {

/// Direction of slip by the state of a ring: 1 or -1, 0 if it sticks.
signed char slip_of(BoxState state) {
  return static_cast<signed char>(state);
}

}  // namespace

SlipZones::SlipZones(Eigen::Index n_rings)
    : labels_(static_cast<std::size_t>(n_rings), never_slipped),
      slip_(labels_.size(), 0),
      held_labels_(labels_),
      depths_(Eigen::VectorXd::Zero(n_rings)),
      held_depths_(depths_) {}

void SlipZones::update(const Eigen::VectorXd& limit, const std::vector<BoxState>& states,
                       const Eigen::VectorXd& depths) {
  // At the very instant at which a ring touches, roundoff would decide whether it slips: it counts as free then.
  const double touches = 1e-10 * limit.maxCoeff();
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    const auto ring = static_cast<Eigen::Index>(i);
    const bool is_free = limit[ring] <= touches;
    const signed char slip = is_free ? 0 : slip_of(states[i]);
    if (slip != slip_[i]) {
      held_labels_[i] = labels_[i];
      held_depths_[ring] = depths_[ring] - depths_[0];
    }
    slip_[i] = slip;
    if (is_free)
      labels_[i] = free;
    else if (slip != 0)
      labels_[i] = slip;
    else if (labels_[i] == free)
      labels_[i] = touched_again;
  }
  depths_ = depths;
}

}  // namespace fretval::fem
