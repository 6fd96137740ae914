#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/box_solver.h"

namespace fretval::fem {

/// How each ring moved last: the traction has kinks where neighbouring rings differ, also long after the slip that made
/// them (see PunchSeries::integral).
class SlipZones {
 public:
  explicit SlipZones(Eigen::Index n_rings);

  /// After a step; states: of the friction problem, limit: mu p.
  void update(const Eigen::VectorXd& limit, const std::vector<BoxState>& states);

  [[nodiscard]] const std::vector<signed char>& labels() const { return labels_; }

 private:
  std::vector<signed char> labels_;
};

}  // namespace fretval::fem
