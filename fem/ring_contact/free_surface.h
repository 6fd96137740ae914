#pragma once

#include <Eigen/Dense>
#include <optional>
#include <utility>
#include <vector>

#include "fem/motion/relaxation.h"
#include "fem/ring_contact/box_solver.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// The gap outside a contact, as a series of punches has it (PunchSeries::displacements), and across its edge: the gap
/// of a ring in contact is the one that it would have if it had not been touched again since it lifted.
struct Opening {
  Eigen::VectorXd value;
  /// Per ring: number of the retreat of the contact in which it lifted, see FreeSurface. Empty: a body without memory,
  /// in which nothing is known of rings in contact.
  Eigen::VectorXi retreat = {};
  Eigen::VectorXd lifted_below = {};  ///< per ring: contact radius at which that retreat began
};

/// Radius at which the gap vanishes, between the last of n_pressed rings and the next one. Empty where it does not, as
/// it jumps at the edge of a flat face. The gap is a cubic on either side of a kink. A kink that lies between the two
/// rings is reached by continuing the inner cubic; where no ring inside has lifted, the outer cubic is continued to the
/// edge.
std::optional<double> edge_of(const Opening& opening, const Eigen::VectorXd& radii, Eigen::Index n_pressed);

/// The surface of a body with memory as it would go on if no ring were touched again after it has lifted.
///
/// A displacement of the series that bears no load relaxes by itself, whatever its neighbours do: the state of a ring
/// as it lifts tells where it is from then on. All rings that have lifted in one retreat of the contact lie on a smooth
/// curve, along which a growing edge runs; it ends with a kink where the retreat began.
class FreeSurface {
 public:
  static constexpr int never_touched = 0, never_lifted = -1;

  /// The surface of a relaxed body with n_pressed rings in contact. state: of the rings. The series must outlive this.
  FreeSurface(const PunchSeries& series, const RingState& state, Eigen::Index n_pressed);

  /// The gaps between this surface and the indenter at the balance time of a step. profile: ring means of the indenter;
  /// depth: indentation of its tip.
  void find_opening(const RelaxationStep& step, const Eigen::VectorXd& profile, double depth, Opening& opening) const;

  /// Moves the surface to the end of a step. state: of the rings then; contact: interior where they touched in the
  /// step; radius: of the contact.
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
  double began_at_ = 0;  // radius of the contact at which the last retreat began
  double radius_ = 0;    // largest radius of the contact since then
  Eigen::VectorXd work_;
};

}  // namespace fretval::fem
