#pragma once

#include <functional>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/springs/spring_foundation.h"
#include "mdr/springs/spring_history.h"
#include "mdr/stick/limiting_profile.h"

namespace fretval::mdr {

/// What a rig prescribes over time, each direction a displacement or a force. A force stands in the motion in the place
/// of the displacement, in N.
struct Prescribed {
  HarmonicMotion motion;  ///< time 0: the largest indentation or normal force
  bool normal_force = false, tangential_force = false;
};

/// Indentation that no relaxation of the body exceeds: of a prescribed force, that of the relaxed body under its
/// largest value (a creep compliance that rises to that of the relaxed body never makes more of it).
double deepest_indentation(const Profile& profile, const PronyBody& body, const Prescribed& prescribed);

/// The largest contact that is possible, with a little room, m.
double largest_radius(const Profile& profile, const PronyBody& body, const Prescribed& prescribed);

/// What springs are stepped under: the mean of each direction, its oscillations rising over ramp_duration in s. The
/// motion is that of the repeating one.
Loading loading_of(const Prescribed& prescribed, const RepeatingMotion& repeating, double ramp_duration);

/// Periodic response of the spring foundation to what is prescribed, over the common period or, of an unlocked phase
/// and of frequencies without one, that of a motion in the place of it (see RepeatingMotion).
struct ForcedResponse {
  NormalResponse normal;
  /// As in SpringHistory; settled, see SpringHistory::settling_depth. First slip: NaN under displacements alone, which
  /// have a closed form (stick_radii).
  StickDepths depths;
  double largest_indentation;    ///< m
  double axis_pressure_max;      ///< Pa; of springs, also under a sharp tip
  double tangential_amplitude;   ///< m, half of what lies between the extremes of u_x
  double tangential_force_max;   ///< N, of |F_x|
  double tangential_force_mean;  ///< N, what slip has locked in
  double friction_work;          ///< J per period
  double bulk_work;              ///< J per period
  double tangential_work;        ///< J per period, area of the tangential loop
};

/// How fine the middle one of three histories is.
struct SpringFineness {
  Eigen::Index n_springs = 200;
  int steps_per_oscillation = 180, n_ramp_periods = 20;
  double periodicity = 1e-8;  ///< see periodicity_of
  int n_oscillations = 48;    ///< in a period of a motion that does not repeat itself
};

/// So many times the springs and steps.
SpringFineness finer(SpringFineness fineness, int times);

/// The transient springs (mdr/springs/spring_history.h), stepped until they repeat. Extrapolated from n and 2 n
/// springs, steps, cycles of the ramp and oscillations in the place of a motion without period, each of second order.
/// error: how far that is from the extrapolation of n/2 and n, or from 2 n, whichever is more, which covers a second
/// order and a first one. With a dashpot, whose load jumps at the edge, the orders scatter: the whole difference of n
/// and 2 n. Throws std::invalid_argument for bad arguments, std::runtime_error when the springs do not become periodic
/// and for a tangential force that no friction holds (gross slip).
struct SteppedForcedResponse {
  ForcedResponse response, error;
};
SteppedForcedResponse forced_response(const Profile& profile, const PronyBody& body, double mu,
                                      const Prescribed& prescribed, const SpringFineness& fineness = {});

/// What steps so many springs under a loading, and the radius of the contact, m, that a history and its largest
/// indentation tell: springs of any kind are extrapolated so.
using HistoryOfSprings =
    std::function<SpringHistory(Eigen::Index n_springs, const Loading& loading, const HistoryControl& control)>;
using ContactRadius = std::function<double(const SpringHistory& history, double largest_indentation)>;

/// g: image of the indenter up to outer_radius, where the springs end.
SteppedForcedResponse extrapolated_response(const HistoryOfSprings& history, const ContactRadius& radius_at,
                                            const std::function<double(double)>& g, double outer_radius,
                                            const PronyBody& body, const Prescribed& prescribed,
                                            const SpringFineness& fineness = {});

/// The response of a worn indenter, whose springs end at its stick radius.
SteppedForcedResponse forced_response(const LimitingProfile& worn, const PronyBody& body, double mu,
                                      const Prescribed& prescribed);

}  // namespace fretval::mdr
