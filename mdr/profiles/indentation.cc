#include "mdr/profiles/indentation.h"

#include <algorithm>
#include <cmath>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

double contact_radius(const Profile& profile, double indentation) {
  require_non_negative("indentation", indentation);
  return inverse_transform(profile, indentation);
}

double normal_force(const Profile& profile, double shear_modulus, double indentation) {
  require_positive("shear modulus", shear_modulus);
  const double a = contact_radius(profile, indentation);
  return 8 * shear_modulus * (a * indentation - transform_integral(profile, a));
}

double pressure(const Profile& profile, double shear_modulus, double indentation, double r) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("radial coordinate r", r);
  const double a = contact_radius(profile, indentation);
  if (r >= a) return 0;
  return 4 * shear_modulus / pi * abel_slope_integral(profile, r, a);
}

double tangential_force_full_stick(const Profile& profile, double shear_modulus, double indentation,
                                   double tangential_displacement) {
  require_positive("shear modulus", shear_modulus);
  require_non_negative("tangential displacement", tangential_displacement);
  return 16.0 / 3 * shear_modulus * contact_radius(profile, indentation) * tangential_displacement;
}

double stick_depth_cattaneo_mindlin(double mu, double indentation, double tangential_displacement) {
  require_positive("coefficient of friction", mu);
  require_non_negative("indentation", indentation);
  require_non_negative("tangential displacement", tangential_displacement);
  return std::max(0.0, indentation - 2 * tangential_displacement / (3 * mu));
}

double stick_radius_cattaneo_mindlin(const Profile& profile, double mu, double indentation,
                                     double tangential_displacement) {
  return inverse_transform(profile, stick_depth_cattaneo_mindlin(mu, indentation, tangential_displacement));
}

double tangential_force_cattaneo_mindlin(const Profile& profile, double shear_modulus, double mu, double indentation,
                                         double tangential_displacement) {
  const double stick_depth = stick_depth_cattaneo_mindlin(mu, indentation, tangential_displacement);
  return mu * (normal_force(profile, shear_modulus, indentation) - normal_force(profile, shear_modulus, stick_depth));
}

}  // namespace fretval::mdr
