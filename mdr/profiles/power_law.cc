#include "mdr/profiles/power_law.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <limits>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// int_0^phi cos^n for whole n, by a recurrence that adds positive terms only.
double whole_cosine_power_integral(int n, double sine, double cosine) {
  double power = n % 2 == 0 ? cosine : cosine * cosine;  // cos^(k-1)
  double integral = n % 2 == 0 ? std::atan2(sine, cosine) : sine;
  for (int k = n % 2 == 0 ? 2 : 3; k <= n; k += 2) {
    integral = (power * sine + (k - 1) * integral) / k;
    power *= cosine * cosine;
  }
  return integral;
}

// sum_k (a)_k/k! y^k/(b + k c): the binomial series of an incomplete beta function, for 0 <= y <= 1/2.
double binomial_series(double a, double b, double c, double y) {
  double term = 1, sum = 1 / b;
  for (int k = 0; k < 200; ++k) {
    term *= (k + a) / (k + 1) * y;
    const double next = term / (b + (k + 1) * c);
    sum += next;
    if (std::abs(next) < std::numeric_limits<double>::epsilon() / 4 * std::abs(sum)) break;
  }
  return sum;
}

// int_0^cosine t^n/sqrt(1-t^2) dt, for cosine^2 <= 1/2.
double near_axis(double n, double cosine) {
  return std::pow(cosine, n + 1) * binomial_series(0.5, n + 1, 2, cosine * cosine);
}

// int_cosine^1 t^n/sqrt(1-t^2) dt = int_0^sine (1-t^2)^((n-1)/2) dt.
double near_edge(const PowerLaw& profile, double sine, double cosine) {
  const double n = profile.exponent;
  if (n == std::floor(n)) return whole_cosine_power_integral(static_cast<int>(n), sine, cosine);
  if (sine * sine <= 0.5) return sine * binomial_series((1 - n) / 2, 1, 2, sine * sine);
  const double whole = pi / 2 * profile.coefficient / profile.image_coefficient;  // pi/(2 kappa_n)
  return whole - near_axis(n, cosine);
}

}  // namespace

double transform_factor(double exponent) {
  require_positive("exponent of the power law", exponent);
  return std::sqrt(pi) / 2 * exponent * boost::math::tgamma_delta_ratio(exponent / 2, 0.5);
}

double shape(const PowerLaw& profile, double r) {
  if (profile.exponent == 2) return profile.coefficient * r * r;
  return profile.coefficient * std::pow(r, profile.exponent);
}

double shape_slope(const PowerLaw& profile, double r) {
  return profile.coefficient * profile.exponent * std::pow(r, profile.exponent - 1);
}

double transform(const PowerLaw& profile, double x) {
  if (profile.exponent == 2) return profile.image_coefficient * x * x;
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
  if (upper == 0) return 0;
  if (upper * upper <= r * r / 2) {
    // In terms of g(x) instead of g(r), which may be out of range far from the contact.
    const auto from_axis = [&](double x) {
      return transform(profile, x) * (x / r) * binomial_series(0.5, n + 1, 2, (x / r) * (x / r));
    };
    return from_axis(upper) - from_axis(lower);
  }
  const auto to_edge = [&](double x) { return near_edge(profile, std::sqrt((r - x) * (r + x)) / r, x / r); };
  return transform(profile, r) * (to_edge(lower) - (upper < r ? to_edge(upper) : 0));
}

}  // namespace fretval::mdr
