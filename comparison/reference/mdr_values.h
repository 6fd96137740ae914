#pragma once

#include <optional>
#include <variant>

#include "comparison/quantities/reading.h"
#include "comparison/reference/mdr_case.h"
#include "mdr/springs/spring_foundation.h"

namespace fretval {

/// Cycles to shakedown by springs of two finenesses, and their error.
struct SettlingCycles {
  double cycles, error;
};

/// Errors of springs that were stepped in time, m; 0: closed forms.
struct SteppingErrors {
  double first_slip = 0, shakedown = 0;  ///< of the stick radii
  double indentation = 0, tangential_amplitude = 0;
};

/// The part of an answer that an indenter as it is described has: none.
struct UnwornAnswer {};

/// The part of an answer that an indenter with a limiting profile has.
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

/// MDR's answer to a case; SI units. Empty stick radii: nothing sticks. A case that is compared has contact_radius_max
/// and normal_force_max.
struct MdrAnswer {
  double modulus_ratio;                      ///< at the normal frequency; NaN of a path, which has none
  std::optional<double> contact_radius_max;  ///< empty: a prescribed force that no contact carries without slip
  std::optional<double> stick_radius_first_slip;
  std::optional<double> stick_radius_shakedown;
  std::optional<double> worn_radius;           ///< a_inf of the limiting profile that belongs to the shakedown radius
  std::optional<double> normal_force_max;      ///< empty: not computed, or as for contact_radius_max
  std::optional<double> indentation_max = {};  ///< periodic; empty: prescribed, or as contact_radius_max
  std::optional<double> tangential_amplitude = {};  ///< half of the range of u_x; empty as indentation_max
  /// Under prescribed displacements it is set by mdr_answer_with_cycle alone. Empty: the indenter is worn or at rest
  /// tangentially, there is no cycle of at most a few hundred oscillations, or the springs do not become periodic.
  std::optional<CycleReadings> cycle = {};
  /// Largest |F_y| and its error by springs, N, for a motion in two directions.
  std::optional<double> transverse_force_max = {};
  double transverse_force_error = 0;
  /// Factor per cycle by which slip dies out where nothing slips in the end (mdr/stick/slip_decay.h); with the cycle.
  std::optional<double> slip_decay = {};
  std::optional<SettlingCycles> cycles_to_shakedown = {};  ///< see settling_cycles
  SteppingErrors stepped = {};
  /// The largest error of the springs: of depths over the largest indentation, of the tangential amplitude over that
  /// amplitude.
  double stepping_error = 0;
  double normal_force_error = 0;                        ///< N, of springs stepped in time; 0: closed form
  double contact_radius_error = 0;                      ///< m, likewise
  std::optional<mdr::AxisPressure> axis_pressure = {};  ///< empty: infinite
  std::optional<double> steady_sliding_share = {};      ///< see steady_sliding_share() of mdr_case.h
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

/// An answer with the values that follow from the normal response alone.
inline MdrAnswer with_normal_response(const mdr::NormalResponse& normal) {
  MdrAnswer answer{};
  answer.contact_radius_max = normal.contact_radius_max;
  answer.normal_force_max = normal.normal_force_max;
  answer.normal_force_error = normal.normal_force_error;
  answer.contact_radius_error = normal.contact_radius_error;
  answer.axis_pressure = normal.axis_pressure;
  return answer;
}

}  // namespace fretval
