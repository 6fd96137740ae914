#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/box_solver.h"

namespace fretval::fem {

/// How each ring moved last: the traction has kinks where neighbouring rings differ, also long after the slip that made
/// them (see PunchSeries::integral).
class SlipZones {
 public:
  enum Label : signed char {
    slipped_backward = -1,
    never_slipped = 0,
    slipped_forward = 1,
    touched_again = 2,
    free = 3
  };

  explicit SlipZones(Eigen::Index n_rings);

  /// After a step; states: of the friction problem, limit: mu p.
  void update(const Eigen::VectorXd& limit, const std::vector<BoxState>& states);

  [[nodiscard]] const std::vector<signed char>& labels() const { return labels_; }

 private:
  std::vector<signed char> labels_;
};

}  // namespace fretval::fem
