#pragma once

#include <optional>
#include <vector>

#include "fem/motion/relaxation.h"
#include "fem/motion/sampled_path.h"

namespace fretval::fem {

/// One cosine of a motion, `amplitude cos(order t + phase)`.
struct Oscillation {
  double amplitude;  ///< not negative
  int order = 1;     ///< oscillations per cycle, positive
  double phase = 0;
  bool across = false;  ///< of a tangential oscillation: it is along y, not x
};

/// Motion of the indenter in dimensionless time t, in which a cycle lasts 2 pi: the common period of all oscillations.
///
///   d = d0 + e(t) sum_j a_j cos(n_j t + phi_j),     u_x = e(t) sum_k b_k cos(m_k (t + s(t)) + psi_k)
///
/// The cycle has to begin and end at its largest indentation, where readings of the contact look for it. The envelope e
/// rises smoothly from 0 to 1 over n_ramp_cycles of the slowest oscillation, so that the history starts relaxed at d0
/// and raises all amplitudes together.
///
/// A locked motion has s = 0, and its period is one cycle. In an unlocked one the tangential motion creeps ahead of the
/// normal one and back, `s = (L/2)(1 - cos(t / n))`, through all lags that differ: L = 2 pi over the least common
/// multiple of how often either direction repeats in a cycle; half of that, pi, for one displacement in each direction,
/// both of the same frequency, where a lag by half a cycle turns the tangential motion round and the load is largest at
/// either end, as the body turns both directions by the same angle. There it rests for an instant. The period in cycles
/// is n = creep_period(n_creep_cycles, highest order).
///
/// Tangential oscillations that go across add up to u_y in the same way as the others to u_x.
///
/// Where a force is prescribed it takes the place of the displacement: F_N(t) that of d, F_x(t) that of u_x. Then a
/// cycle begins at the largest normal force, and the displacements follow from the contact.
///
/// A path takes the place of the cosines, d = d_rest + e(t) (d_path - d_rest), and u_x with a rest of 0, or the forces.
/// Its period is one cycle; it may begin anywhere. A single pass has e = 1 from the start on, at its first row, and
/// ends after one cycle.
struct Motion {
  double indentation;
  std::vector<Oscillation> normal, tangential;
  bool locked = true;
  int n_ramp_cycles = 10;
  int n_creep_cycles = 48;
  bool normal_force = false, tangential_force = false;  ///< what is prescribed; false: a displacement

  std::optional<SampledPath> path = {};

  [[nodiscard]] bool is_single_pass() const { return path && !path->repeats; }
  [[nodiscard]] bool has_forces() const { return normal_force || tangential_force; }
  [[nodiscard]] int cycles_per_period() const;
  /// Oscillations per cycle of the fastest oscillation, and of the fastest normal one; at least 1.
  [[nodiscard]] int highest_order() const;
  [[nodiscard]] int highest_normal_order() const;
  /// Whole cycles until the ramp is over.
  [[nodiscard]] int cycles_of_ramp() const;
  /// Sum of the tangential amplitudes, a bound of |u_x| or |F_x| and of the length of (u_x, u_y).
  [[nodiscard]] double tangential_amplitude() const;
  /// Whether anything goes across, along y.
  [[nodiscard]] bool moves_across() const;
};

/// Cycles in which an unlocked motion creeps there and back: n_creep_cycles, or half as many where one of them has more
/// than one oscillation. A period of half as many cycles creeps twice as fast, and the difference tells the error of
/// creeping.
int creep_period(int n_creep_cycles, int highest_order);

/// One cosine in each direction, of the same frequency. phase: by which the tangential one is ahead, rad; empty:
/// unlocked.
Motion one_frequency(double indentation, double normal_amplitude, double tangential_amplitude,
                     std::optional<double> phase);

/// The envelope e: share of the amplitudes at a time; 1 after the ramp.
double amplitude_share(const Motion& motion, double t);

ValueAndRate normal_motion(const Motion& motion, double t);
ValueAndRate tangential_motion(const Motion& motion, double t);
ValueAndRate transverse_motion(const Motion& motion, double t);

/// These motions at a time t in a step. Where t is a row of a path, which has two rates, the rate is that on the side
/// of inside_step, an instant within the step.
ValueAndRate normal_motion_inside(const Motion& motion, double t, double inside_step);
ValueAndRate tangential_motion_inside(const Motion& motion, double t, double inside_step);
ValueAndRate transverse_motion_inside(const Motion& motion, double t, double inside_step);

/// Length of the tangential path in a cycle, to and fro: for cosines 4 amplitudes for each oscillation or, where the
/// indenter moves across as well, the length of its curve.
double tangential_path(const Motion& motion);

/// Times at which the steps of a history begin. The steps are equal for cosines; along a path every row is the end of a
/// step.
class StepTimes {
 public:
  StepTimes(const Motion& motion, int steps_per_cycle);
  /// Equal steps.
  StepTimes(int steps_per_cycle);  // NOLINT(google-explicit-constructor): a number of steps is all there is to it
  [[nodiscard]] int steps_per_cycle() const { return steps_per_cycle_; }
  /// Beginning of a step, counted from 0 for the first one of the history.
  [[nodiscard]] double begin(long step) const;
  /// Where a step lies in its piece of a path; empty: the motion is made of cosines.
  [[nodiscard]] std::optional<StepInPiece> in_piece(long step) const;

 private:
  int steps_per_cycle_;
  double dt_;
  std::vector<StepInPiece> steps_;
};

}  // namespace fretval::fem
