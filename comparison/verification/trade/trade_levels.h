#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/reference/mdr_document.h"

namespace fretval {

/// The closed form with its periodic normal response, over and over for half a second; the stick radii alone, which
/// need no response, as often.
struct ClosedForm {
  MdrAnswer answer;
  double seconds;              ///< of the fastest one
  double stick_radii_seconds;  ///< likewise
};

/// Throws std::runtime_error where the reference fails.
ClosedForm closed_form(const PreparedCase& prepared);

/// The spring foundation stepped through the motion at one setting; it has stick radii and force, no contact radius.
struct SpringLevel {
  SpringSetting setting;
  Quantities errors;  ///< empty: it failed
  double seconds = 0;
  std::string failure = {};
};

/// From 50 springs on; none for a worn indenter or an unlocked phase.
std::vector<SpringLevel> spring_levels(const PreparedCase& prepared, const Quantities& reference);

/// The finite elements stepped with every degree of freedom as an unknown, for two cycles. They equal the condensed
/// ones (fem/full_model/full_history.h), so their error is that of the same setting. An unlocked phase is a right angle
/// here: the cost of a step does not depend on it.
struct FullLevel {
  Resolution resolution;
  unsigned n_dofs = 0;
  double body_seconds = 0, seconds_per_normal_step = 0, seconds_per_friction_step = 0;
  std::optional<double> memory_bytes = {};  ///< measured peak growth of the process, see ResidentGrowth
  std::string failure = {};

  /// Extrapolated to so many steps.
  [[nodiscard]] double seconds(long n_normal_steps, long n_friction_steps) const {
    return body_seconds + seconds_per_normal_step * static_cast<double>(n_normal_steps) +
           seconds_per_friction_step * static_cast<double>(n_friction_steps);
  }
};

FullLevel full_level(const PreparedCase& prepared, const Resolution& resolution);

}  // namespace fretval
