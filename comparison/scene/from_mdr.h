#pragma once

#include <functional>
#include <optional>

namespace fretval {

/// What MDR expects of a contact under a prescribed normal force, where the case does not say how deep it is. Guesses,
/// which choose units, a mesh and a cycle: an error in them costs rings or steps and nothing else. Lengths in m.
struct ExpectedContact {
  double largest_indentation;             ///< or more
  std::optional<double> carrying_radius;  ///< that carries prescribed forces alone in the limiting state
};

/// The limiting profile of wear as an indenter (Wear / State = limiting): what finite elements are given by MDR, to
/// find out whether it wears. Lengths in m.
struct LimitingIndenter {
  double stick_radius, outer_radius;     ///< where it departs from the unworn profile: c and a_inf
  std::function<double(double)> height;  ///< at a radius
  /// Of the first harmonic; where the case leaves it to the profile (shakedown), the one whose shakedown radius is c.
  double tangential_amplitude;
};

}  // namespace fretval
