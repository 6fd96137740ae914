#pragma once

#include "mdr/profiles/profile.h"

namespace fretval::mdr {

/// Elastic contact of an unworn indenter under prescribed forces: the inverses of the solutions in
/// mdr/profiles/indentation.h. Shear modulus G in Pa, forces in N, lengths in m. Throws std::invalid_argument for bad
/// arguments and std::runtime_error should the search for the indentation fail.

/// The indentation d with 8 G int_0^a (d - g) dx = F, g(a) = d. Parabola: d = (3 F/(16 G sqrt(R)))^(2/3).
/// F not negative. Accurate to roundoff.
double indentation_for_force(const Profile& profile, double shear_modulus, double normal_force);

/// The u_x of Cattaneo and Mindlin under F and then F_x:
///   u_x = (3 mu/2)(d(F) - d(F - F_x/mu)),   d(F) as above
/// The difference leaves u_x an absolute error of roundoff of (3 mu/2) d.
/// 0 <= F_x <= mu F; F_x > mu F slides without limit, which is an error that says so.
double tangential_displacement_for_force(const Profile& profile, double shear_modulus, double mu, double normal_force,
                                         double tangential_force);

}  // namespace fretval::mdr
