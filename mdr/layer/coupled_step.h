#pragma once

#include <optional>
#include <vector>

#include "mdr/layer/coupled_bed.h"
#include "mdr/layer/row_solver.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/springs/force_balance.h"
#include "mdr/springs/spring_step.h"

namespace fretval::mdr {

/// One time step of the springs of a viscoelastic layer: mdr/springs/spring_step.h, whose body bears what the springs
/// do and what the layer couples to it,
///
///   q_z + coupling(q_z) = E*/G0 int G(t-t') u_z' dt' >= 0 ...,   q_x likewise with G*/G0,   |q_x| <= mu q_z
///
/// As all moduli share one G(t), tips and memories are those of independent springs, and only the loads are found
/// together: normal ones first, then tangential ones between their limits (mdr/layer/row_solver.h). Loads of the state
/// are over E* and G* with the relaxed modulus. The rules in time are those of SpringStep, of second order; a spring
/// that touches in the step is free until then, so that only the share of the step counts in which it is in contact.
/// With a dashpot the load of a spring jumps when it touches, and which springs touch is judged by the coupling at the
/// start of the step. Without a dashpot the spring within which the contact ends bears a rim load in addition (see
/// RowProblem), which takes part in the coupling and in the force on the indenter; friction and tips are judged at the
/// middles of springs.
///
/// A sibling of SpringStep and not a part of it: its pass over the springs is as fast as it is because no spring knows
/// of another.
class CoupledStep {
 public:
  /// mu and dt positive. bed: outlives the step. Throws std::invalid_argument.
  CoupledStep(const CoupledBed& bed, const PronyBody& body, double mu, double dt);

  /// Moves the springs to the end of the step. Prescribed loads are sums of width * load in m^2. Throws GrossSlip when
  /// friction cannot carry a tangential one, std::runtime_error when no loads were found.
  void advance(SpringState& state, const PrescribedInStep& prescribed) const;

 private:
  [[nodiscard]] Eigen::ArrayXd left_of(const Eigen::ArrayXXd& memory) const;
  [[nodiscard]] Eigen::ArrayXd tip_under(const Eigen::ArrayXd& load, const Eigen::ArrayXd& load_before,
                                         const Eigen::ArrayXd& position, const Eigen::ArrayXXd& memory) const;
  void remember(Eigen::ArrayXXd& memory, const Eigen::ArrayXd& move) const;
  [[nodiscard]] double coasting_rate(double now, double before) const;

  /// The row of springs in one direction, with the prescribed y as guess, or with the start of the search for it and
  /// the prescribed sum of the loads.
  struct Request {
    RowProblem row;
    double guess;
    std::optional<double> sum;
  };
  struct Normal {
    Eigen::ArrayXd load, rim_load, depth;
    Eigen::ArrayXd held;  ///< share of the step during which each spring is in contact
    double indentation;
  };
  [[nodiscard]] Request normal_request(const SpringState& state, const PrescribedInStep& prescribed) const;
  [[nodiscard]] Normal normal_step(const SpringState& state, const PrescribedInStep& prescribed) const;
  struct Tangential {
    Eigen::ArrayXd load, tip, slip;
    double shift;
  };
  [[nodiscard]] static Tangential at_rest(const SpringState& state);
  [[nodiscard]] Request tangential_request(const SpringState& state, const PrescribedInStep& prescribed,
                                           const Normal& normal, const Eigen::ArrayXd& free_tips) const;
  [[nodiscard]] Tangential tangential_step(const SpringState& state, const PrescribedInStep& prescribed,
                                           const Normal& normal) const;

  const CoupledBed& bed_;
  mutable RowSolver normal_row_, tangential_row_;  // what they remember changes how fast they are, and roundoff
  double limit_;                                   // mu E*/G*
  double dt_;                                      // s
  std::vector<double> decay_;                      // exp(-dt/tau_i)
  std::vector<double> gain_;                       // (G_i/G0) (tau_i/dt) (1 - decay_i)
  double gain_sum_, stiffness_;
  double viscosity_;  // eta/G0 in s
  double theta_;      // weight of the end of the step in the exponentially fitted rule
};

/// Coupled springs that have relaxed for ever at this indentation, without tangential displacement.
SpringState relaxed_state(const CoupledBed& bed, const PronyBody& body, double indentation);

/// The indentation in m at which relaxed coupled springs bear sum(width * load) in m^2, positive.
double relaxed_indentation(const CoupledBed& bed, double load);

}  // namespace fretval::mdr
