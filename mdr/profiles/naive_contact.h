#pragma once

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// What MDR's springs say of a profile whose image may fall, without regard to whether MDR holds for it: every spring
/// presses that the image g reaches, `d > g(x)`, wherever they stand.
///
///   F/G = 8 int_0^inf max(d - g(x), 0) dx      a = the outermost x that presses
///
/// Where g rises this is MDR, and exact; where it falls, it is off by whatever a comparison with another method shows.
/// A table knows no springs beyond its last row.
struct NaiveContact {
  double force_over_modulus;  ///< m^2; force of the relaxed body at rest over its shear modulus
  double radius;              ///< m; 0: nothing presses
};

/// depth: of the indenter below its first touch, in m, not negative.
NaiveContact naive_contact(const Profile& profile, double depth);

}  // namespace fretval::mdr
