#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "mdr/springs/spring_step.h"
#include "mdr/stick/stick_radius.h"

namespace fretval::mdr {

/// Motion of the indenter in time.
using IndenterPath = std::function<IndenterState(double time)>;

/// Prescribed force in N over time.
using ForcePath = std::function<double(double time)>;

/// What a rig prescribes over time: the path of the indenter, or instead of either of its directions a force.
struct Loading {
  IndenterPath path;           ///< its indentation at time 0 is the start; not needed under two forces
  ForcePath normal_force;      ///< empty: the indentation is prescribed; positive
  ForcePath tangential_force;  ///< empty: the tangential displacement is prescribed; 0 at time 0
};

/// How a history is stepped, and when it counts as periodic.
struct HistoryControl {
  double period;  ///< s
  int steps_per_period = 360;
  int n_ramp_periods = 10;  ///< after which the path is taken as periodic
  int max_periods = 400;
  double periodicity = 1e-9;  ///< largest change of a traction from one period to the next over the largest traction
  /// Ends a history, too: whether the slip of each spring in a period after the ramp, m, is little enough. Empty: a
  /// history ends when its tractions repeat.
  std::function<bool(const Eigen::ArrayXd& slip)> slips_little = {};
  bool watches_first_slip = true;  ///< false: depths.first_slip is not asked for, and NaN
};

/// What the transient spring foundation says about a periodic motion: the second, independent way to both stick radii,
/// and the reference for histories of finite elements.
struct SpringHistory {
  int n_periods;          ///< periods until it is periodic, those of the ramp included
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
  std::vector<Eigen::ArrayXd> slip_of_periods;  ///< per spring: path of slip in each period from rest on, m
  Eigen::ArrayXd mean_traction;  ///< per spring: mean tangential_load over the last period, the locked-in offset, m

  SpringState deepest, highest;  ///< at the largest and the smallest indentation of the last period
  SpringState last;              ///< at the end of the last period

  double friction_work;    ///< J per period
  double bulk_work;        ///< J per period
  double indenter_work;    ///< J per period: int F_z dd + F_x du_x; friction_work + bulk_work up to the time step
  double tangential_work;  ///< J per period: int F_x du_x, the tangential part of indenter_work
};

constexpr double settling_slip = 1e-4;

}  // namespace fretval::mdr
