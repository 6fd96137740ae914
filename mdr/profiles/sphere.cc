#include "mdr/profiles/sphere.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fretval::mdr {

namespace {

// Share of R that the largest contact leaves free at the rim, where g is infinite.
constexpr double least_rest = 1e-6;

// Below this share of R the closed form of the volume cancels; the series is good to roundoff there.
constexpr double small_ratio = 0.3;

// sqrt(R^2 - r^2)
double height_of_arc(const Sphere& profile, double r) {
  return std::sqrt(std::max(0.0, profile.radius - r) * (profile.radius + r));
}

// artanh(x/R) of the distance R - x, which keeps its digits where x has none left of it; finite for quadratures to R.
double artanh_from_end(const Sphere& profile, double distance) {
  distance = std::max(distance, 1e-300 * profile.radius);
  return std::log1p(2 * (profile.radius - distance) / distance) / 2;
}

// g'(x)/x as a function of x, even and smooth.
double slope_over_x(const Sphere& profile, double x) {
  const double R = profile.radius, t = x / R;
  const double artanh_over_t = t < 1e-4 ? 1 + t * t / 3 : std::atanh(t) / t;
  return (artanh_over_t + 1 / ((1 - t) * (1 + t))) / R;
}

// sum over k >= 1 of t^(2k+1)/(4 k^2 - 1), which is (t - (1 - t^2) artanh(t))/2.
double volume_series(double t) {
  double power = t, sum = 0;
  for (int k = 1; k < 40; ++k) {
    power *= t * t;
    const double term = power / (4.0 * k * k - 1);
    sum += term;
    if (term < std::numeric_limits<double>::epsilon() / 4 * sum) break;
  }
  return sum;
}

}  // namespace

double largest_depth(const Sphere& profile) {
  return transform(profile, profile.radius * (1 - least_rest));
}

double shape(const Sphere& profile, double r) {
  return r * r / (profile.radius + height_of_arc(profile, r));
}

double shape_slope(const Sphere& profile, double r) {
  return r / height_of_arc(profile, r);
}

double transform(const Sphere& profile, double x) {
  x = std::abs(x);
  return x * std::atanh(std::min(1.0, x / profile.radius));
}

double transform_slope(const Sphere& profile, double x) {
  return x * slope_over_x(profile, x);
}

double transform_integral(const Sphere& profile, double x) {
  const double R = profile.radius, t = std::min(1.0, x / R);
  if (t < small_ratio) return R * R * volume_series(t);
  if (t == 1) return R * R / 2;
  return R * R / 2 * (t - (1 - t) * (1 + t) * std::atanh(t));
}

double inverse_transform(const Sphere& profile, double depth) {
  if (depth == 0) return 0;
  // With a = R tanh(u) it is u tanh(u) = d/R, and u/(1+u) <= tanh(u) <= min(u, 1) brackets u.
  const double ratio = depth / profile.radius;
  const double lower = std::max(ratio, std::sqrt(ratio)), upper = (ratio + std::sqrt(ratio * (ratio + 4))) / 2;
  const auto excess = [ratio](double u) { return u * std::tanh(u) - ratio; };
  const double excess_lower = excess(lower), excess_upper = excess(upper);
  if (excess_lower >= 0) return profile.radius * std::tanh(lower);
  if (excess_upper <= 0) return profile.radius * std::tanh(upper);
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(excess, lower, upper, excess_lower, excess_upper,
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return profile.radius * std::tanh((bracket.first + bracket.second) / 2);
}

double abel_slope_integral(const Sphere& profile, double r, double a) {
  // With x^2 = r^2 + s^2 it is the integral of g'(x)/x ds, which has no singularity.
  const double end = std::sqrt((a - r) * (a + r));
  const auto integrand = [&](double s) { return slope_over_x(profile, std::hypot(r, s)); };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, end, 12, 1e-12);
}

double abel_depth_integral(const Sphere& profile, double lower, double upper, double r) {
  if (upper <= lower) return 0;
  const auto root_at = [r](double x) { return std::sqrt((r - x) * (r + x)); };
  boost::math::quadrature::tanh_sinh<double> quadrature;
  // x = r sin(t), or r cos(t) where the integral begins or ends next to r: each angle is accurate at one end.
  if (upper < root_at(upper)) {
    const auto angle = [&](double x) { return std::atan2(x, root_at(x)); };
    return quadrature.integrate([&](double t) { return transform(profile, r * std::sin(t)); }, angle(lower),
                                angle(upper), 1e-13);
  }
  const auto angle = [&](double x) { return std::atan2(root_at(x), x); };
  const auto integrand = [&](double t) {
    const double below = 2 * r * std::sin(t / 2) * std::sin(t / 2), x = r - below;
    return x * artanh_from_end(profile, profile.radius - r + below);
  };
  return quadrature.integrate(integrand, angle(upper), angle(lower), 1e-13);
}

}  // namespace fretval::mdr
