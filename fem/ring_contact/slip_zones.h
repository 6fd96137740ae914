#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/ring_contact/box_solver.h"

namespace fretval::fem {

/// How each ring moved last, and its state when its present slip began. The traction has kinks where neighbouring rings
/// differ in how they moved, also long after the slip that made them. The state when slip began locates the edge of a
/// stick zone: the traction of rings that stick goes on beyond the edge of the stick zone as if the rings that slip had
/// not begun to, also when hardly a ring of the zone is left (see friction_force).
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

  /// To be called after each step. limit: mu p; states: those of the rings in the friction problem; depths: of the
  /// traction (PunchSeries::depths).
  void update(const Eigen::VectorXd& limit, const std::vector<BoxState>& states, const Eigen::VectorXd& depths);

  [[nodiscard]] const std::vector<signed char>& labels() const { return labels_; }
  /// Per ring: 1 or -1 if it slips forward or backward; 0 if it sticks or does not touch.
  [[nodiscard]] const std::vector<signed char>& slip() const { return slip_; }
  /// Depths of the traction after the last step.
  [[nodiscard]] const Eigen::VectorXd& depths() const { return depths_; }
  /// Labels just before the present slip began.
  [[nodiscard]] const std::vector<signed char>& held_labels() const { return held_labels_; }
  /// Depths just before the present slip began, over that of the innermost ring.
  [[nodiscard]] const Eigen::VectorXd& held_depths() const { return held_depths_; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(labels_, slip_, held_labels_, depths_, held_depths_);
  }

 private:
  std::vector<signed char> labels_, slip_, held_labels_;
  Eigen::VectorXd depths_, held_depths_;
};

}  // namespace fretval::fem
