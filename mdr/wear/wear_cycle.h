#pragma once

#include <Eigen/Core>

#include "mdr/motion/motion.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_history.h"
#include "mdr/springs/spring_step.h"
#include "mdr/wear/abel_matrices.h"

namespace fretval::mdr {

/// What wear needs to know of a periodic cycle: columns are its instants. Springs that repeat only after several
/// cycles, as dashpots that lose contact may do, are followed for all of them, and path and work are shared out to one.
struct WearCycle {
  Eigen::MatrixXd path;   ///< rings: path of slip in m, of each step half to the instant before and half to that after
  Eigen::MatrixXd load;   ///< springs: normal_load in m; less than 0: the gap in m between tip and indenter
  double friction_work;   ///< J, of the springs
  double contact_radius;  ///< outer edge of the outermost spring that touches in the cycle, m
  double stick_radius;    ///< outer edge of the outermost spring of those around the axis that do not slip, m
};

/// Springs under an oscillating indenter that loses its shape: owns their state.
class WearingSprings {
 public:
  /// Starts relaxed at d0 on the profile of the bed and raises the amplitudes over three cycles.
  WearingSprings(const SpringBed& bed, const PronyBody& body, double mu, const Motion& motion, int steps_per_cycle);

  /// Sets g of the springs.
  void set_depth(const Eigen::ArrayXd& depth);

  /// Runs cycles until the tractions repeat, after up to 12 cycles, to 1e-8 of the largest, so that the slip which
  /// settling takes is not taken for wear of every cycle, and measures one. A spring that slips by less than 1e-6 of
  /// u_x0 in a cycle has shaken down: what is left of its slip dies out, and does not count. Throws std::runtime_error
  /// when they do not settle.
  WearCycle settled_cycle(const AbelMatrices& matrices);

  [[nodiscard]] const SpringBed& bed() const { return bed_; }

 private:
  int settle();  // returns the number of cycles after which the tractions repeat
  void step(int k);
  [[nodiscard]] Eigen::ArrayXd slip_in_contact(const SpringState& before) const;
  void find_radii(WearCycle& cycle, const Eigen::MatrixXd& slip) const;

  PronyBody body_;
  double mu_;
  Motion motion_;
  int steps_per_cycle_;
  double dt_;
  IndenterPath path_;
  SpringBed bed_;
  SpringStep step_;
  SpringState state_;
  int n_cycles_ = 0;
};

}  // namespace fretval::mdr
