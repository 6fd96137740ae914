#pragma once

namespace fretval {

/// How finely a scene is discretised.
struct Resolution {
  unsigned elements_per_radius;  ///< rings per contact radius
  unsigned degree;               ///< of the displacement
  double growth;                 ///< element size per distance from the contact
  double far_radius;             ///< over the contact radius
  int steps_per_cycle;
  int n_ramp_cycles;
  double periodicity;  ///< largest relative change from one period to the next
};

/// The settings that meet a relative tolerance on the stick radius, from the measured errors in docs/accuracy.md.
Resolution resolution_for(double tolerance);

}  // namespace fretval
