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

/// The loading under which springs are stepped: the mean of each direction, with oscillations that rise over
/// ramp_duration in s. The motion is that of `repeating`.
Loading loading_of(const Prescribed& prescribed, const RepeatingMotion& repeating, double ramp_duration);

/// Periodic response of the spring foundation to what is prescribed, over the common period of its frequencies; with an
/// unlocked phase, or without a common period, over that of the RepeatingMotion that stands for it.
struct ForcedResponse {
  NormalResponse normal;
  /// Depths g(c) in m of the stick zones, as in SpringHistory; that of shakedown is SpringHistory::settling_depth.
  /// First slip is NaN under displacements alone, for which stick_radii() has a closed form.
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

/// Fineness of the middle one of the three histories from which a response is extrapolated.
struct SpringFineness {
  Eigen::Index n_springs = 200;
  int steps_per_oscillation = 180, n_ramp_periods = 4;
  double periodicity = 1e-8;  ///< see periodicity_of
  int n_oscillations = 48;    ///< in a period of a RepeatingMotion that stands for another motion
};

/// Response of the transient springs (mdr/springs/spring_history.h), stepped until they repeat. It is extrapolated from
/// n and 2 n springs, steps, cycles of the ramp and oscillations of a RepeatingMotion, each of second order. error: its
/// distance from the extrapolation of n/2 and n, or from the values of 2 n, whichever is more, which covers orders from
/// one to two. Where a branch relaxes within a step, it is of first order in time, and error is no less than twice that
/// from the values of 2 n, as a first order has it. With a dashpot, whose load jumps at the edge, the orders scatter,
/// and error is the whole difference of n
/// and 2 n; that of the work in the body has the share of springs that let go within a period, if they are fewer than
/// one. Where the ring that slips is narrower than a spring, sums are of first order, and errors of tangential forces
/// and of the tangential amplitude have the share of a spring. Throws std::invalid_argument for bad arguments,
/// std::runtime_error when the springs do not become periodic and for a tangential force that no friction holds (gross
/// slip): this is stepped once more on a ramp five times as long, on which the amplitude grows by less in a cycle.
struct SteppedForcedResponse {
  ForcedResponse response, error;
};
SteppedForcedResponse forced_response(const Profile& profile, const PronyBody& body, double mu,
                                      const Prescribed& prescribed, const SpringFineness& fineness = {});

/// Springs of any kind that can be extrapolated in this way: what steps n_springs of them under a loading, and what
/// reads the radius of the contact in m from a history and its largest indentation in m.
using HistoryOfSprings =
    std::function<SpringHistory(Eigen::Index n_springs, const Loading& loading, const HistoryControl& control)>;
using ContactRadius = std::function<double(const SpringHistory& history, double largest_indentation)>;

/// Whether a spring knows of the others. With a dashpot a spring that touches or not then moves all loads by what it
/// bears itself, so that the differences of two numbers of springs scatter, and error is no less than that of the
/// extrapolation of n/2 and n.
enum class Springs { independent, coupled };

/// The extrapolated response of springs of any kind. g: image of the indenter in m, up to outer_radius in m, where the
/// springs end.
SteppedForcedResponse extrapolated_response(const HistoryOfSprings& history, const ContactRadius& radius_at,
                                            const std::function<double(double)>& g, double outer_radius,
                                            const PronyBody& body, double mu, const Prescribed& prescribed,
                                            const SpringFineness& fineness = {},
                                            Springs springs = Springs::independent);

/// The response of a worn indenter, whose springs end at its stick radius.
SteppedForcedResponse forced_response(const LimitingProfile& worn, const PronyBody& body, double mu,
                                      const Prescribed& prescribed);

}  // namespace fretval::mdr
