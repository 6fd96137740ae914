#pragma once

#include <optional>
#include <variant>

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

/// What springs stepped in time may be off by, m; 0: closed forms.
struct SteppingErrors {
  double first_slip = 0, shakedown = 0;  ///< of the stick radii
  double indentation = 0, tangential_amplitude = 0;
};

/// Of an indenter as it is described.
struct UnwornAnswer {};

/// Of an indenter that is a limiting profile.
struct LimitingAnswer {
  /// Tangential amplitude that it is the limiting profile for, over that of the case; 0: there is none. Empty: it does
  /// not move tangentially.
  std::optional<double> amplitude = {};
};

/// The whole contact begins to slide under a prescribed tangential force while all amplitudes rise slowly. Then an
/// answer has nothing else but the normal response.
struct GrossSlipShare {
  double amplitude;                 ///< of all oscillations then, over that of the case
  std::optional<double> time = {};  ///< s, of a single pass, in the time of its rows
};

/// What MDR says about a case; SI units. Empty radii: nothing sticks. A comparable case has both maxima.
struct MdrAnswer {
  double modulus_ratio;                      ///< at the normal frequency; NaN of a path, which has none
  std::optional<double> contact_radius_max;  ///< empty: a prescribed force that no contact carries without slip
  std::optional<double> stick_radius_first_slip;
  std::optional<double> stick_radius_shakedown;
  std::optional<double> worn_radius;           ///< a_inf of the limiting profile that belongs to the shakedown radius
  std::optional<double> normal_force_max;      ///< empty: not computed, or as above
  std::optional<double> indentation_max = {};  ///< in the periodic state; empty: prescribed, or as above
  std::optional<double> tangential_amplitude = {};  ///< half of what lies between the extremes of u_x; likewise
  /// Under prescribed displacements see mdr_answer_with_cycle. Empty: worn, at rest tangentially, without a cycle of a
  /// few hundred oscillations, or not periodic in the end.
  std::optional<MdrCycle> cycle = {};
  /// N, of |F_y|, and what springs may be off by; of a motion in two directions.
  std::optional<double> transverse_force_max = {};
  double transverse_force_error = 0;
  /// Factor per cycle by which slip dies out where nothing slips in the end (mdr/stick/slip_decay.h); with the cycle.
  std::optional<double> slip_decay = {};
  std::optional<SettlingCycles> cycles_to_shakedown = {};  ///< see settling_cycles
  SteppingErrors stepped = {};
  /// The largest of them, of depths and over what they are errors of.
  double stepping_error = 0;
  double normal_force_error = 0;                        ///< N, likewise
  std::optional<mdr::AxisPressure> axis_pressure = {};  ///< empty: infinite
  std::optional<double> steady_sliding_share = {};      ///< see steady_sliding_share
  MotionKind motion_kind = MotionKind::cycles;
  /// What an answer has by the indenter, or where all of its contact slides.
  std::variant<UnwornAnswer, LimitingAnswer, GrossSlipShare> of_kind = {};

  /// Null: it is of another kind.
  template <class Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&of_kind);
  }
  /// Whether all of the largest contact sticks in the end, as it does under a profile that is limiting for the motion.
  [[nodiscard]] bool wears_no_more() const;
};

/// What an answer takes from the normal response alone.
inline MdrAnswer with_normal_response(const mdr::NormalResponse& normal) {
  MdrAnswer answer{};
  answer.contact_radius_max = normal.contact_radius_max;
  answer.normal_force_max = normal.normal_force_max;
  answer.normal_force_error = normal.normal_force_error;
  answer.axis_pressure = normal.axis_pressure;
  return answer;
}

}  // namespace fretval
