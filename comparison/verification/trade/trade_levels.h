#pragma once

#include <optional>
#include <string>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/verification/trade/trade_plan.h"

namespace fretval {

/// The closed form with its periodic normal response, over and over for half a second; the stick radii alone, which
/// need no response, as often.
struct ClosedForm {
  MdrAnswer answer;
  Quantities measures;
  double seconds;              ///< of the fastest one
  double stick_radii_seconds;  ///< likewise
  int n_repetitions;
};

/// Throws std::runtime_error where the reference fails.
ClosedForm closed_form(const PreparedCase& prepared);

/// The spring foundation stepped through the motion at one setting; it has stick radii and force, no contact radius.
struct SpringPoint {
  SpringSetting setting;
  Quantities errors;  ///< empty: it failed
  double seconds = 0;
  double memory_bytes = 0;  ///< estimate: what the springs remember and the sampled minima of their margins
  int n_periods = 0;
  std::string failure;
};

/// Needs an unworn indenter and a locked phase: see has_springs. Seconds: of the fastest of n_repetitions runs.
SpringPoint spring_point(const PreparedCase& prepared, const SpringSetting& setting, const Quantities& reference,
                         int n_repetitions);
bool has_springs(const PreparedCase& prepared);

/// The finite elements stepped with every degree of freedom as an unknown, for as few cycles as the condensed ones need
/// to be asked for, and the condensed ones through the same steps.
///
/// The start takes one cycle here, and an unlocked phase is locked at 90 degrees: that changes what is computed, not
/// what a step costs.
struct FullPoint {
  Resolution resolution;
  unsigned n_dofs = 0;
  long n_normal_steps = 0, n_friction_steps = 0;  ///< measured; friction: 0 without tangential motion
  double body_seconds = 0;                        ///< mesh, assembly and factorisation
  double normal_seconds = 0, friction_seconds = 0;
  double pressure_difference = 0;      ///< largest, from the condensed ones, over the largest pressure
  double traction_difference = 0;      ///< likewise of the tractions of the last cycle
  std::optional<double> memory_bytes;  ///< measured, see ResidentGrowth: body and histories
  std::string failure;

  /// Measured.
  [[nodiscard]] double seconds_per_normal_step() const;
  [[nodiscard]] double seconds_per_friction_step() const;
  /// Extrapolated: the body and as many steps as a whole history has, each as long as the measured ones.
  [[nodiscard]] double extrapolated_seconds(long n_normal_steps, long n_friction_steps) const;
};

FullPoint full_point(const PreparedCase& prepared, const Resolution& resolution);

}  // namespace fretval
