#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "mdr/rheology/prony_body.h"
#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// Position and velocity of the rigid indenter at an instant, in m and m/s.
struct IndenterState {
  double indentation;
  double indentation_rate;
  double tangential;
  double tangential_rate;
};

/// What the springs remember. Loads are divided by the relaxed stiffness, so that they are lengths:
///   q_z = 4 G0 normal_load,   q_x = (8/3) G0 tangential_load      (forces per length, in N/m)
struct SpringState {
  IndenterState indenter;
  Eigen::ArrayXd normal_depth;      ///< u_z of the tips in m
  Eigen::ArrayXd tangential_shift;  ///< u_x of the tips in m
  Eigen::ArrayXd normal_load;       ///< m, not negative
  Eigen::ArrayXd tangential_load;   ///< m, at most (3 mu/2) normal_load in magnitude
  /// Slip of each spring against the indenter in the last step, in m; none while it does not touch, and exactly none
  /// while it sticks.
  Eigen::ArrayXd slip;
  Eigen::ArrayXXd normal_memory;      ///< springs x branches: branch forces over 4 G0, in m
  Eigen::ArrayXXd tangential_memory;  ///< springs x branches: branch forces over (8/3) G0, in m
  IndenterState indenter_before;      ///< one step earlier; equal to indenter at the start
  Eigen::ArrayXd rim_load = {};       ///< m, of coupled springs, see mdr/layer/row_solver.h; empty: of independent ones
};

/// Force of branch i at the end of a step of length dt per displacement made in it at constant rate, over the relaxed
/// stiffness: (G_i/G0) (tau_i/dt) (1 - exp(-dt/tau_i)).
double branch_gain(const PronyBody& body, std::size_t i, double dt);

/// Springs that have relaxed for ever at this indentation, without tangential displacement.
SpringState relaxed_state(const SpringBed& bed, const PronyBody& body, double indentation);

/// The whole contact slides under a prescribed tangential force.
struct GrossSlip : std::runtime_error {
  using std::runtime_error::runtime_error;
  double time = 0;       ///< s, of a history; at the end of the step in which it slides
  double amplitude = 1;  ///< amplitudes of all oscillations at that time, over those after the ramp (forced_response)
  double excess = 0;     ///< sum(width * load) that is asked for beyond what friction holds, m^2
};

/// Load of each spring at the end of a step, in which the indenter arrives at the indentation d: slope (d - zero)
/// where d > touch, else none. touch >= zero; with a dashpot the load jumps where a spring touches.
struct NormalLines {
  Eigen::ArrayXd zero, touch;  ///< m
  double slope;
};

/// Tangential load of each spring at the end of a step in which the indenter moves by `shift` in m: value + slope *
/// shift, limited to `most` in magnitude.
struct TangentialLines {
  Eigen::ArrayXd value, slope, most;  ///< m, 1, m
};

/// One time step of the transient spring foundation: unilateral contact and Coulomb friction per spring,
///
///   q_z = 4 int G(t-t') u_z' dt' >= 0,  u_z >= d - g,  q_z (u_z - d + g) = 0
///   q_x = (8/3) int G(t-t') u_x' dt',   |q_x| <= mu q_z, slip where it is equal
///
/// Source: paper, equations (1), (5), (6), (8). The tips move linearly over the step, for which the Prony update is
/// exact; second order in dt. A spring that touches in the step is free until then. In a body with a dashpot a tip in
/// contact has the indenter's own velocity, and a free or slipping one is integrated by the exponentially fitted theta
/// rule, also of second order and damped for every dt.
class SpringStep {
 public:
  /// mu and dt positive. Throws std::invalid_argument.
  SpringStep(const PronyBody& body, double mu, double dt);

  /// Moves the springs to the end of the step, where the indenter is at `to`.
  void advance(SpringState& state, const SpringBed& bed, const IndenterState& to) const;

  /// State at the end of the step of an indenter that follows a force to this indentation and tangential displacement,
  /// with the rates of the parabolas through them and the last two positions (BDF2: second order, and no ringing). With
  /// a dashpot the force depends on these rates.
  [[nodiscard]] IndenterState arrived(const SpringState& state, double indentation, double tangential) const;

  /// What the springs bear at the end of a step that brings the indenter to arrived(d, u_x), for all d or all u_x at
  /// once, as the balance of a prescribed force needs it (mdr/springs/force_balance.h).
  [[nodiscard]] NormalLines normal_lines(const SpringState& state, const SpringBed& bed) const;
  [[nodiscard]] TangentialLines tangential_lines(const SpringState& state, const SpringBed& bed,
                                                 double indentation) const;

 private:
  /// Position of a tip, m, at the end of a step in which its load, averaged with theta, is given. position: at the
  /// start, m; left: what is left at the end of the branch forces at the start, m; force_now: force of relaxed spring
  /// and branches at the start, m.
  struct TipRule {
    double viscous, theta, gain_sum, weight;  // eta/(G0 dt), -, -, viscous + theta (1 + gain_sum)
    [[nodiscard]] double operator()(double load, double position, double left, double force_now) const {
      return (load + viscous * position - theta * (left - gain_sum * position) - (1 - theta) * force_now) / weight;
    }
  };

  /// Calls pass(n) with the number of branches as a compile-time constant, -1 for more than three, in wide registers.
  template <class Pass>
  void for_branches(const Pass& pass) const;
  /// SpringLines: what a pass over the springs needs of the step, by value, so that nothing it writes to can change it.
  template <int n_branches>
  [[nodiscard]] auto lines_of(Eigen::Index n_springs) const;
  template <bool has_dashpot, int n_branches>
  void advance_springs(SpringState& state, const SpringBed& bed, const IndenterState& to) const;

  double limit_;               // (3/2) mu
  double dt_;                  // s
  std::vector<double> decay_;  // exp(-dt/tau_i)
  std::vector<double> gain_;   // (G_i/G0) (tau_i/dt) (1 - decay_i)
  double gain_sum_;
  double viscosity_;  // eta/G0 in s
  TipRule tip_under_;
};

}  // namespace fretval::mdr
