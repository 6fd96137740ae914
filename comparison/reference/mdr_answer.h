#pragma once

#include <optional>

#include "comparison/reference/mdr_case.h"
#include "mdr/springs/spring_foundation.h"

namespace fretval {

/// What a locked motion asks of whoever drives it, in a cycle of the periodic state, from the transient springs; SI
/// units. Extrapolated from two finenesses.
struct MdrCycle {
  double tangential_force_max;   ///< of |F_x|
  double tangential_force_mean;  ///< what slip has locked in
  double friction_work;          ///< lost to friction
  double bulk_work;              ///< lost inside the body
  double tangential_work;        ///< area of the tangential loop
  double sliding_force;          ///< mu times the largest normal force
  double sliding_work;           ///< what sliding under that force along the whole tangential path would cost
  double force_error;            ///< of either force
  double work_error;             ///< of either loss
  double loop_error;             ///< of the area
  /// The largest force. With a dashpot loads jump where springs touch, which few springs and steps do not show in an
  /// instant: there only with a tolerance of a cycle.
  bool knows_largest_force = true;
};

/// Cycles to shakedown, as springs of two finenesses find them; error: of these.
struct SettlingCycles {
  double cycles, error;
};

/// What MDR says about a case; SI units. Empty radii: nothing sticks. A comparable case has both maxima.
struct MdrAnswer {
  double modulus_ratio;                      ///< at the normal frequency; NaN of a path, which has none
  std::optional<double> contact_radius_max;  ///< empty: a prescribed force that no contact carries without slip
  std::optional<double> stick_radius_first_slip;
  std::optional<double> stick_radius_shakedown;
  std::optional<double> worn_radius;       ///< a_inf of the limiting profile that belongs to the shakedown radius
  std::optional<double> normal_force_max;  ///< empty: not computed, or as above
  /// Tangential amplitude that the indenter is the limiting profile for, over that of the case; 0: there is none.
  /// Empty: the indenter is not worn, or does not move tangentially.
  std::optional<double> limiting_amplitude = {};
  std::optional<double> indentation_max = {};       ///< in the periodic state; empty: prescribed, or as above
  std::optional<double> tangential_amplitude = {};  ///< half of what lies between the extremes of u_x; likewise
  /// Under prescribed displacements see mdr_answer_with_cycle. Empty: worn, at rest tangentially, without a cycle of a
  /// few hundred oscillations, or not periodic in the end.
  std::optional<MdrCycle> cycle = {};
  /// Factor per cycle by which slip dies out where nothing slips in the end (mdr/stick/slip_decay.h); with the cycle.
  std::optional<double> slip_decay = {};
  std::optional<SettlingCycles> cycles_to_shakedown = {};  ///< see settling_cycles
  /// Of springs that were stepped in time, the largest relative error of what is above; 0: closed forms.
  double stepping_error = 0;
  double normal_force_error = 0;                        ///< N, likewise
  std::optional<mdr::AxisPressure> axis_pressure = {};  ///< empty: infinite
  /// Of all amplitudes, the share at which the whole contact begins to slide under a prescribed tangential force while
  /// they rise slowly; then all else but the normal response is empty. Empty: it never does.
  std::optional<double> gross_slip = {};
  std::optional<double> gross_slip_time = {};       ///< s, of a single pass, in the time of its rows
  std::optional<double> steady_sliding_share = {};  ///< see steady_sliding_share
  bool single_pass = false;  ///< then there is no periodic state, no shakedown radius and no limiting profile

  /// Whether all of the largest contact sticks in the end, as it does under a profile that is limiting for the motion.
  [[nodiscard]] bool wears_no_more() const;
};

/// Normal response of the spring foundation in the periodic state; depends on the normal motion alone.
mdr::NormalResponse mdr_normal_response(const MdrCase& mdr);

/// The profile in which the case wears no more: the indenter itself if it is worn already, or else the limiting
/// profile of the shakedown radius; under forces that of their limiting state. Empty: nothing sticks, and wear goes on
/// for ever; or a path.
std::optional<mdr::LimitingProfile> worn_profile(const MdrCase& mdr, const std::optional<double>& shakedown_radius);

MdrAnswer mdr_answer(const MdrCase& mdr, const mdr::NormalResponse& normal);

/// After how many cycles from rest nothing slips any more inside the shakedown radius (see cycles_until), of transient
/// springs: some milliseconds. n_ramp: oscillations over which amplitudes rise. Empty: a worn indenter, a path, a
/// motion without a period, an elastic body, which shakes down at once, springs that do not become periodic, or nothing
/// that slips first and not in the end.
std::optional<SettlingCycles> settling_cycles(const MdrCase& mdr, const MdrAnswer& answer, int n_ramp);

/// The same with the cycle also under prescribed displacements, for which springs are stepped: some ten milliseconds
/// for what is a closed form otherwise. With a tolerance of a cycle, of up to eight times the springs and steps, until
/// their error is a quarter of it.
MdrAnswer mdr_answer_with_cycle(const MdrCase& mdr, const mdr::NormalResponse& normal);

}  // namespace fretval
