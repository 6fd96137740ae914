#pragma once

#include <functional>
#include <vector>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/motion/repeating_motion.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_step.h"
#include "mdr/stick/stick_radius.h"

namespace fretval::mdr {

/// Motion of the indenter in time.
using IndenterPath = std::function<IndenterState(double time)>;

/// How much of the amplitudes there is at a time in s, while they rise from rest over ramp_duration in s, and what that
/// changes by per second: x^3 (10 - 15 x + 6 x^2), whose slope and curvature are 0 at both ends.
double amplitude_share(double time, double ramp_duration);
double amplitude_share_rate(double time, double ramp_duration);

/// Oscillation that starts from rest at d0: all amplitudes rise together and smoothly over ramp_duration in s. The
/// phase of a motion is taken as locked, that of a repeating one creeps as it says.
IndenterPath ramped_path(const HarmonicMotion& motion, double ramp_duration);
IndenterPath ramped_path(const RepeatingMotion& repeating, double ramp_duration);

/// Periods after which creep is over, of which a ramp under forces has as many: ten creep times.
int periods_of_creep(const PronyBody& body, double period);

/// Prescribed force in N over time.
using ForcePath = std::function<double(double time)>;

/// What a rig prescribes over time: the path of the indenter, or instead of either of its directions a force.
struct Loading {
  IndenterPath path;           ///< its indentation at time 0 is the start; not needed under two forces
  ForcePath normal_force;      ///< empty: the indentation is prescribed; positive
  ForcePath tangential_force;  ///< empty: the tangential displacement is prescribed; 0 at time 0
};

/// Forces F0 + Delta F cos(2 pi f t) and F_x0 cos(2 pi f t + phase), the oscillating parts rising over ramp_duration
/// in s. mean positive, amplitudes not negative, f in Hz positive, phase in rad.
ForcePath ramped_force(double mean, double amplitude, double frequency, double phase, double ramp_duration);

/// How a history is stepped, and when it counts as periodic.
struct HistoryControl {
  double period;  ///< s
  int steps_per_period = 360;
  int n_ramp_periods = 10;  ///< the path is taken as periodic from here on
  int max_periods = 400;
  double periodicity = 1e-9;  ///< largest change of a traction from one period to the next over the largest traction
  /// Ends a history as well, after the ramp: whether the slip of the springs in a period, m, is little enough. Empty:
  /// none is.
  std::function<bool(const Eigen::ArrayXd& slip)> slips_little = {};
  bool watches_first_slip = true;  ///< false: depths.first_slip is not asked for, and NaN
};

/// What the transient spring foundation says about a periodic motion: the second, independent way to both stick radii,
/// and the reference for histories of finite elements.
struct SpringHistory {
  int n_periods;          ///< until periodic, with those of the ramp
  StickDepths depths;     ///< g(c); see below
  double settling_depth;  ///< as depths.shakedown, if springs that still settle are counted among those that stick
  double largest_shift;   ///< tangential displacement of the indenter, m

  // The last period, both ends included.
  std::vector<double> time;                     ///< s
  std::vector<double> indentation;              ///< m
  std::vector<double> tangential_displacement;  ///< of the indenter, m
  std::vector<double> normal_force;             ///< N
  std::vector<double> tangential_force;         ///< N
  std::vector<double> axis_pressure;            ///< Pa
  Eigen::ArrayXd slip_amplitude;                ///< per spring: path of slip in the last period, m
  std::vector<Eigen::ArrayXd> slip_of_periods;  ///< the same in each period from rest on
  Eigen::ArrayXd mean_traction;  ///< per spring: mean tangential_load over the last period, the locked-in offset, m

  SpringState deepest, highest;  ///< at the largest and the smallest indentation of the last period
  SpringState last;              ///< at its end

  double friction_work;    ///< J per period
  double bulk_work;        ///< J per period
  double indenter_work;    ///< J per period: int F_z dd + F_x du_x; the sum of the other two, up to the time step
  double tangential_work;  ///< J per period: int F_x du_x, a part of that
};

constexpr double settling_slip = 1e-4;

/// Steps the springs from the relaxed state at the path's start until their tractions repeat.
///
/// Stick depths: the friction margin of a spring that sticks, over its stiffness, is g(c) - g(x), so every stuck
/// spring gives g(c); the outermost one is taken. First slip: least margin min(mu q_z -+ q_x) over the whole history of
/// springs that never slipped; shakedown: mean of the two least margins over the last period, of springs that do not
/// slip in it. Minima between time steps are those of parabolas. Not positive where no spring sticks.
/// Under a prescribed force the motion of the indenter is found in every step; it is the same for all springs, so the
/// margins mean the same. Where slip dies out slowly everywhere (a body much stiffer in motion than at rest), tractions
/// repeat while springs still slip a little; settling_depth counts springs that slip by up to settling_slip of the
/// largest tangential displacement in the period: their margins are those of springs that stick.
/// Throws std::runtime_error when the state is not periodic after max_periods or the contact slides under a tangential
/// force, std::invalid_argument for bad arguments.
SpringHistory spring_history(const SpringBed& bed, const PronyBody& body, double mu, const Loading& loading,
                             const HistoryControl& control);

}  // namespace fretval::mdr
