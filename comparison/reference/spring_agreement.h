#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mdr/profiles/profile.h"
#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_history.h"

namespace fretval {

/// The stick radii of the closed formula. Empty: nothing sticks.
struct ClosedForm {
  std::optional<double> first_slip, shakedown;
  bool has_first_slip = true;  ///< false: the first-slip radius of the formula belongs to another contact
};

/// How far transient springs are from the closed formula, and why.
struct SpringAgreement {
  std::optional<double> first_slip;  ///< stick radius of springs less that of the formula, over the radius of the bed
  double shakedown;                  ///< the same difference for shakedown; where nothing sticks a radius is 0
  double slip_inside;  ///< longest slip of a spring inside the shakedown radius of the formula, in the last period,
                       ///< over the largest tangential displacement
  std::vector<std::string> warnings;  ///< of radii that differ by more than a spring: by how much, and which to trust
};
SpringAgreement spring_agreement(const mdr::SpringBed& bed, const mdr::SpringHistory& history,
                                 const mdr::Profile& profile, const ClosedForm& closed_form);

}  // namespace fretval
