#include "mdr/power_law.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

#include "mdr/checks.h"

namespace fretval::mdr {

namespace {

// int_0^phi cos^n. The recurrence for whole n adds positive terms only.
double cosine_power_integral(double n, double phi) {
  if (n != std::floor(n)) {
    const double s = std::sin(phi);
    return boost::math::beta(0.5, (n + 1) / 2, s * s) / 2;
  }
  const int order = static_cast<int>(n);
  const double sine = std::sin(phi), cosine = std::cos(phi);
  double power = order % 2 == 0 ? cosine : cosine * cosine;  // cos^(k-1)
  double integral = order % 2 == 0 ? phi : sine;
  for (int k = order % 2 == 0 ? 2 : 3; k <= order; k += 2) {
    integral = (power * sine + (k - 1) * integral) / k;
    power *= cosine * cosine;
  }
  return integral;
}

}  // namespace

double transform_factor(double exponent) {
  require_positive("exponent of the power law", exponent);
  return std::sqrt(std::acos(-1.0)) / 2 * exponent * boost::math::tgamma_delta_ratio(exponent / 2, 0.5);
}

double shape(const PowerLaw& profile, double r) {
  return profile.coefficient * std::pow(r, profile.exponent);
}

double shape_slope(const PowerLaw& profile, double r) {
  return profile.coefficient * profile.exponent * std::pow(r, profile.exponent - 1);
}

double transform(const PowerLaw& profile, double x) {
  return profile.image_coefficient * std::pow(std::abs(x), profile.exponent);
}

double transform_slope(const PowerLaw& profile, double x) {
  return profile.image_coefficient * profile.exponent * std::pow(x, profile.exponent - 1);
}

double transform_integral(const PowerLaw& profile, double x) {
  return transform(profile, x) * x / (profile.exponent + 1);
}

double inverse_transform(const PowerLaw& profile, double depth) {
  const double ratio = depth / profile.image_coefficient;
  if (profile.exponent == 2) return std::sqrt(ratio);
  if (profile.exponent == 1) return ratio;
  return std::pow(ratio, 1 / profile.exponent);
}

double abel_slope_integral(const PowerLaw& profile, double r, double a) {
  const double n = profile.exponent;
  // Below the smallest normal number a/r overflows; no other r is that close to the axis.
  if (r <= a * std::numeric_limits<double>::min()) {
    if (n <= 1) return std::numeric_limits<double>::infinity();
    return transform_slope(profile, a) / (n - 1);
  }
  // x = r cosh(t) removes the root at x = r and leaves an integrand without any singularity, scaled by its value at the
  // upper end against overflow. With 1 + excess = a/r the limit arcosh(a/r) keeps its relative accuracy as r -> a.
  const double excess = (a - r) / r;
  const double limit = std::log1p(excess + std::sqrt(excess) * std::sqrt(2 + excess));
  if (n == 1) return profile.image_coefficient * limit;
  if (n == 2) return 2 * profile.image_coefficient * std::sqrt((a - r) * (a + r));
  const auto integrand = [&](double t) { return std::pow(r / a * std::cosh(t), n - 1); };
  // The error estimate is that of the embedded Gauss rule; the Kronrod value itself is good to roundoff.
  return transform_slope(profile, a) *
         boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, limit, 12, 1e-11);
}

double abel_depth_integral(const PowerLaw& profile, double lower, double upper, double r) {
  const double n = profile.exponent;
  if (2 * upper < r) {
    const auto from_axis = [&](double x) { return boost::math::beta((n + 1) / 2, 0.5, (x / r) * (x / r)) / 2; };
    return transform(profile, r) * (from_axis(upper) - (lower > 0 ? from_axis(lower) : 0));
  }
  // arccos(x/r) with its relative accuracy as x -> r.
  const auto to_edge = [&](double x) { return cosine_power_integral(n, std::atan2(std::sqrt((r - x) * (r + x)), x)); };
  return transform(profile, r) * (to_edge(lower) - (upper < r ? to_edge(upper) : 0));
}

}  // namespace fretval::mdr
