#pragma once

#include <optional>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// Where a case lies on the maps of MDR's error, all by MDR over its own body with friction of one direction.
struct Coordinates {
  double contact_radius = 0;                    ///< m, largest
  double normal_force = 0;                      ///< N, largest
  std::optional<double> first_slip, shakedown;  ///< stick radii over the contact radius; empty: nothing sticks
  double phase = 0;                             ///< deg, 0 to 180: a mirror turns a motion by 180
  double poisson_ratio = 0.5;
  double radius_over_thickness = 0;  ///< of a layer; 0: a half-space
};

/// A phase in degrees as the maps have it, from 0 to 180.
double phase_on_maps(double phase);

/// answer: MDR's to the case.
Coordinates coordinates_of(const Case& input, const MdrAnswer& answer);

/// The coordinates of a case that MDR is asked about here: what its contact keeps of friction plays no part.
Coordinates coordinates_of(const Case& input);

}  // namespace fretval
