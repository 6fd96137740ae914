#pragma once

#include <Eigen/Dense>
#include <optional>
#include <utility>
#include <vector>

#include "fem/motion/relaxation.h"
#include "fem/ring_contact/box_solver.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// The gap outside a contact, as a series of punches has it (PunchSeries::displacements), and across its edge: that of
/// a ring in contact is what it would be had nothing touched it since it lifted.
struct Opening {
  Eigen::VectorXd value;
  Eigen::VectorXi retreat = {};  ///< of the contact, in which a ring lifted; see FreeSurface. Empty: none has, and of
                                 ///< rings in contact nothing is known, as in a body without memory
  Eigen::VectorXd lifted_below = {};  ///< radius of the contact from which that began
};

/// Where it vanishes between the last of n_pressed rings and the next one. Empty where it does not: it jumps
/// at the edge of a face. Cubics on either side of a kink; where that lies between the two, the one inside goes on to
/// it, and where nothing inside has lifted, what is outside goes on to the edge.
std::optional<double> edge_of(const Opening& opening, const Eigen::VectorXd& radii, Eigen::Index n_pressed);

/// The surface of a body with memory as it would go on if no ring were touched again after it has lifted.
///
/// A displacement of the series that bears nothing relaxes by itself, whatever its neighbours do: what is kept of a
/// ring as it lifts tells where it is from then on. All that have lifted in one retreat of the contact lie on a smooth
/// curve, which a growing edge runs along; it ends with a kink where the retreat began.
class FreeSurface {
 public:
  static constexpr int never_touched = 0, never_lifted = -1;

  /// Relaxed, with n_pressed rings in contact. The series must outlive this.
  FreeSurface(const PunchSeries& series, const RingState& state, Eigen::Index n_pressed);

  /// The gaps that it leaves at the balance time of a step. profile: of the indenter, whose tip is at that depth.
  void find_opening(const RelaxationStep& step, const Eigen::VectorXd& profile, double depth, Opening& opening) const;

  /// To the end of a step. state: of the rings; contact: interior where they touched in the step, up to a radius.
  void advance(const RelaxationStep& step, const RingState& state, const std::vector<BoxState>& contact, double radius);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(state_, retreat_, lifted_below_, n_pressed_, n_retreats_, is_retreating_, began_at_, radius_);
  }

 private:
  const PunchSeries& series_;
  RingState state_;
  Eigen::VectorXi retreat_;
  Eigen::VectorXd lifted_below_;
  Eigen::Index n_pressed_;
  int n_retreats_ = 0;
  bool is_retreating_ = false;
  double began_at_ = 0;  // radius of the contact, the last retreat
  double radius_ = 0;    // largest since then
  Eigen::VectorXd work_;
};

}  // namespace fretval::fem
