#include "mdr/stick/surface_fields.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>

#include "mdr/profiles/indentation.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// arcsin(a/r) for r >= a, accurate as r -> a.
double arcsine(double a, double r) {
  return std::atan2(a, std::sqrt((r - a) * (r + a)));
}

// (2/pi) int_0^a (d - g)/sqrt(r^2-x^2) dx at r >= a.
double displacement_outside(const Profile& profile, double a, double indentation, double r) {
  return 2 / pi * (indentation * arcsine(a, r) - abel_depth_integral(profile, 0, a, r));
}

double smooth_part(const LimitingProfile& profile, double shear_modulus, double r) {
  const double c = profile.stick_radius;
  return r < c ? 4 * shear_modulus / pi * abel_slope_integral(profile.unworn, r, c) : 0;
}

void check_limiting(const LimitingProfile& profile, double indentation, double r) {
  // A caller's own d0 + Delta d may exceed d_max by roundoff.
  require_within("indentation", indentation, 0, profile.maximum_indentation * (1 + 1e-12));
  require_non_negative("radial coordinate r", r);
}

}  // namespace

double total(const EdgeStress& stress, double r) {
  const double c = stress.edge_radius;
  if (stress.intensity == 0) return stress.regular;
  if (r > c) return 0;
  if (r == c) return std::copysign(std::numeric_limits<double>::infinity(), stress.intensity);
  return stress.regular + stress.intensity / std::sqrt((c - r) * (c + r));
}

double normal_displacement(const Profile& profile, double indentation, double r) {
  require_non_negative("radial coordinate r", r);
  const double a = contact_radius(profile, indentation);
  return r <= a ? indentation - shape(profile, r) : displacement_outside(profile, a, indentation, r);
}

double tangential_displacement_cattaneo_mindlin(const Profile& profile, double mu, double indentation,
                                                double tangential_displacement, double r) {
  const double depth = stick_depth_cattaneo_mindlin(mu, indentation, tangential_displacement);
  if (depth > 0 && r <= inverse_transform(profile, depth)) return tangential_displacement;
  return 1.5 * mu *
         (normal_displacement(profile, indentation, r) - (depth > 0 ? normal_displacement(profile, depth, r) : 0));
}

double traction_cattaneo_mindlin(const Profile& profile, double shear_modulus, double mu, double indentation,
                                 double tangential_displacement, double r) {
  const double depth = stick_depth_cattaneo_mindlin(mu, indentation, tangential_displacement);
  return mu * (pressure(profile, shear_modulus, indentation, r) - pressure(profile, shear_modulus, depth, r));
}

EdgeStress limiting_pressure(const LimitingProfile& profile, double shear_modulus, double indentation, double r) {
  check_limiting(profile, indentation, r);
  require_positive("shear modulus", shear_modulus);
  const double c = profile.stick_radius;
  const double jump = indentation - transform(profile.unworn, c);
  if (jump <= 0) return {pressure(profile.unworn, shear_modulus, indentation, r), 0, c};
  return {smooth_part(profile, shear_modulus, r), 4 * shear_modulus / pi * jump, c};
}

double limiting_normal_displacement(const LimitingProfile& profile, double indentation, double r) {
  check_limiting(profile, indentation, r);
  const double c = profile.stick_radius;
  if (indentation <= transform(profile.unworn, c)) return normal_displacement(profile.unworn, indentation, r);
  return r <= c ? indentation - shape(profile.unworn, r) : displacement_outside(profile.unworn, c, indentation, r);
}

EdgeStress limiting_traction(const LimitingProfile& profile, double shear_modulus, double tangential_displacement,
                             double r) {
  require_positive("shear modulus", shear_modulus);
  require_finite("tangential displacement", tangential_displacement);
  require_non_negative("radial coordinate r", r);
  return {0, 8 * shear_modulus / (3 * pi) * tangential_displacement, profile.stick_radius};
}

double limiting_tangential_displacement(const LimitingProfile& profile, double tangential_displacement, double r) {
  require_finite("tangential displacement", tangential_displacement);
  require_non_negative("radial coordinate r", r);
  const double c = profile.stick_radius;
  return r <= c ? tangential_displacement : 2 / pi * tangential_displacement * arcsine(c, r);
}

LimitingStresses limiting_stresses(const LimitingProfile& profile, const Rheology& body, const Motion& motion, double r,
                                   double time) {
  validate(motion);
  require_non_negative("radial coordinate r", r);
  require_finite("time", time);
  if (!motion.phase) throw std::invalid_argument("phase is unlocked: stresses at an instant need a locked phase");
  const double omega_z = angular_frequency(motion.normal_frequency);
  const double omega_x = angular_frequency(motion.tangential_frequency);
  const std::complex<double> normal = complex_modulus(body, omega_z), tangential = complex_modulus(body, omega_x);
  const double G0 = relaxed_modulus(body), c = profile.stick_radius;
  const double rest = motion.indentation - transform(profile.unworn, c);
  const double swing = std::abs(normal) / G0 * motion.normal_amplitude;
  if (rest < swing)
    reject("mean indentation beyond the stick depth in m", rest,
           "must be at least rho Delta d = " + std::to_string(swing) + " m for permanent contact inside c");
  const double lift = motion.normal_amplitude * (normal * std::polar(1.0, omega_z * time)).real();
  const double shift =
      motion.tangential_amplitude * (tangential * std::polar(1.0, omega_x * time + *motion.phase)).real();
  return {{smooth_part(profile, G0, r), 4 / pi * (G0 * rest + lift), c}, {0, 8 / (3 * pi) * shift, c}};
}

}  // namespace fretval::mdr
