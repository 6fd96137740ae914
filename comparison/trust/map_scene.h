#pragma once

#include <string>

#include "comparison/case/case.h"

namespace fretval {

/// A point of a map of MDR's error, from which its case is made. All but the indenter, mu and k are coordinates.
struct MapScene {
  double stick_ratio;  ///< shakedown radius over the largest contact radius, by MDR over the body of the scene
  double phase = 60;   ///< deg
  double poisson_ratio = 0.5;
  double radius_over_thickness = 0;  ///< a/H of a bonded layer, with the largest contact radius by MDR; 0: a half-space
  bool coupled = false;              ///< whether pressure and friction are coupled; friction is a vector in any case
  bool by_normal_force = false;      ///< whether the normal force is prescribed; false: the indentation
  // These are the same at all points of a map, and differ in the scenes elsewhere.
  double friction_coefficient = 0.5;
  double amplitude_ratio = 0.5;  ///< k = 3 mu Δd / (2 u_x0)
  double cone_angle = 0;         ///< deg, between generatrix and surface; 0: a parabola
  bool viscoelastic = false;     ///< a standard solid of ωτ = 1 whose modulus rises threefold
};

/// The case of a scene: its largest contact radius is 1 mm, and its amplitudes are what MDR needs for the stick ratio.
/// Throws std::runtime_error where no amplitudes lead to that.
Case case_of(const MapScene& scene);

}  // namespace fretval
