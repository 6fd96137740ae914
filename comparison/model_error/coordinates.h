#pragma once

#include <optional>

#include "comparison/case/case.h"
#include "comparison/reference/mdr_answer.h"

namespace fretval {

/// Place of a case on the maps of MDR's error, by MDR over the body of the case with friction of one direction.
struct Coordinates {
  double contact_radius = 0;                    ///< m, largest
  double normal_force = 0;                      ///< N, largest
  std::optional<double> first_slip, shakedown;  ///< stick radii over the contact radius; empty: nothing sticks
  double phase = 0;                             ///< deg, 0 to 180: a mirror turns a motion by 180
  double poisson_ratio = 0.5;
  double radius_over_thickness = 0;  ///< of a layer; 0: a half-space
};

/// The phase in degrees from 0 to 180 that is equivalent to a phase on the maps.
double phase_on_maps(double phase);

/// The coordinates of a case. answer: MDR's answer to it.
Coordinates coordinates_of(const Case& input, const MdrAnswer& answer);

/// The coordinates of a case by an answer of MDR that is computed here, whatever friction the case asks for.
Coordinates coordinates_of(const Case& input);

}  // namespace fretval
