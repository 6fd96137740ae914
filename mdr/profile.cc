#include "mdr/profile.h"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>

#include "mdr/checks.h"

namespace fretval::mdr {

namespace {
const double pi = std::acos(-1.0);
}

Profile parabola(double radius) {
  require_positive("radius of the parabola", radius);
  return {1 / (2 * radius), 2};
}

Profile cone(double slope_angle) {
  require_finite("slope angle of the cone", slope_angle);
  if (!(slope_angle > 0 && slope_angle < pi / 2)) {
    reject("slope angle of the cone", slope_angle, "must lie strictly between 0 and pi/2 rad");
  }
  return {std::tan(slope_angle), 1};
}

Profile power_law(double coefficient, double exponent) {
  require_positive("coefficient of the power law", coefficient);
  require_within("exponent of the power law", exponent, 0.5, 20);
  return {coefficient, exponent};
}

double transform_factor(double exponent) {
  require_positive("exponent of the power law", exponent);
  return std::sqrt(pi) / 2 * exponent * boost::math::tgamma_delta_ratio(exponent / 2, 0.5);
}

double shape(const Profile& profile, double r) {
  require_non_negative("radial coordinate r", r);
  return profile.coefficient * std::pow(r, profile.exponent);
}

double shape_slope(const Profile& profile, double r) {
  require_non_negative("radial coordinate r", r);
  return profile.coefficient * profile.exponent * std::pow(r, profile.exponent - 1);
}

double transform(const Profile& profile, double x) {
  require_finite("coordinate x", x);
  return transform_factor(profile.exponent) * shape(profile, std::abs(x));
}

double transform_slope(const Profile& profile, double x) {
  require_non_negative("coordinate x", x);
  return transform_factor(profile.exponent) * shape_slope(profile, x);
}

double inverse_transform(const Profile& profile, double depth) {
  require_non_negative("depth of the one-dimensional profile", depth);
  return std::pow(depth / (transform_factor(profile.exponent) * profile.coefficient), 1 / profile.exponent);
}

}  // namespace fretval::mdr
