#include "mdr/profiles/flat_faced.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace fretval::mdr {

namespace {

// Below this angle the closed forms cancel; above, they are good to 1e-14.
constexpr double small_angle = 0.3;

// int_0^phi of a smooth function; to roundoff for phi < small_angle.
template <class Function>
double integral_to(double phi, const Function& function) {
  return boost::math::quadrature::gauss<double, 15>::integrate(function, 0.0, phi);
}

double square(double x) {
  return x * x;
}

// The angle arccos(b/x) with its functions, which would lose digits if computed from it for b << x.
struct Flank {
  double angle, sine, cosine;
  [[nodiscard]] double tangent() const { return sine / cosine; }
};

// root = sqrt(x^2-b^2)
Flank flank_with_root(const FlatFaced& profile, double root) {
  const double b = profile.flat_radius, x = std::hypot(root, b);
  return {std::atan2(root, b), root / x, b / x};
}

Flank flank_at(const FlatFaced& profile, double x) {
  const double b = profile.flat_radius;
  return flank_with_root(profile, std::sqrt((x - b) * (x + b)));
}

double tan_minus_angle(const Flank& flank) {
  if (flank.angle > small_angle) return flank.tangent() - flank.angle;
  return integral_to(flank.angle, [](double psi) { return square(std::tan(psi)); });
}

double angle_minus_half_sine(const Flank& flank) {  // phi - sin(phi) cos(phi)
  if (flank.angle > small_angle) return flank.angle - flank.sine * flank.cosine;
  return integral_to(flank.angle, [](double psi) { return 2 * square(std::sin(psi)); });
}

double rounding_volume(const Flank& flank) {  // sin^3/(3 cos) - (phi - sin cos)/2
  if (flank.angle > small_angle)
    return square(flank.sine) * flank.tangent() / 3 - (flank.angle - flank.sine * flank.cosine) / 2;
  return integral_to(flank.angle, [](double psi) { return square(std::tan(psi) * std::sin(psi)) / 3; });
}

double image_over_x(const FlatFaced& profile, const Flank& flank) {
  return profile.edge_slope * flank.angle + profile.curvature * profile.flat_radius * tan_minus_angle(flank);
}

}  // namespace

double shape(const FlatFaced& profile, double r) {
  const double t = std::max(0.0, r - profile.flat_radius);
  return t * (profile.edge_slope + t * profile.curvature / 2);
}

double shape_slope(const FlatFaced& profile, double r) {
  if (r < profile.flat_radius) return 0;
  return profile.edge_slope + (r - profile.flat_radius) * profile.curvature;
}

double transform(const FlatFaced& profile, double x) {
  x = std::abs(x);
  if (x <= profile.flat_radius) return 0;
  return x * image_over_x(profile, flank_at(profile, x));
}

double transform_slope(const FlatFaced& profile, double x) {
  if (x < profile.flat_radius) return 0;
  if (x == profile.flat_radius) return profile.edge_slope > 0 ? std::numeric_limits<double>::infinity() : 0;
  const Flank flank = flank_at(profile, x);
  return profile.edge_slope * (flank.angle + 1 / flank.tangent()) +
         profile.curvature * profile.flat_radius * (tan_minus_angle(flank) + flank.tangent());
}

double transform_integral(const FlatFaced& profile, double x) {
  if (x <= profile.flat_radius) return 0;
  const Flank flank = flank_at(profile, x);
  return x * x *
         (profile.edge_slope * angle_minus_half_sine(flank) / 2 +
          profile.curvature * profile.flat_radius * rounding_volume(flank));
}

double inverse_transform(const FlatFaced& profile, double depth) {
  if (depth == 0) return profile.flat_radius;
  const auto excess = [&](double x) { return transform(profile, x) - depth; };
  double upper = 2 * profile.flat_radius;
  while (excess(upper) < 0) upper *= 2;
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(excess, profile.flat_radius, upper, -depth, excess(upper),
                                                         boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

double abel_slope_integral(const FlatFaced& profile, double r, double a) {
  const double b = profile.flat_radius;
  if (a <= b) return 0;
  // With S = sqrt(x^2-b^2) and delta = sqrt|r^2-b^2|, x^2 - r^2 is S^2 + delta^2 below the edge of the flat and
  // S^2 - delta^2 above: S = delta sinh(u) or delta cosh(u) leaves g'(x) S/x du, smooth on the scale of u = 1 however
  // close r is to b.
  const double delta = std::sqrt(std::abs(r - b) * (r + b));
  if (delta == 0 && profile.edge_slope > 0) return std::numeric_limits<double>::infinity();
  const double scale = std::max(delta, 1e-9 * b);  // without a break of slope the rest is of order scale^2
  const double end = std::asinh(std::sqrt((a - std::max(r, b)) * (a + std::max(r, b))) / scale);
  const auto integrand = [&](double u) {
    const Flank flank = flank_with_root(profile, scale * (r < b ? std::sinh(u) : std::cosh(u)));
    return profile.edge_slope * (flank.angle * flank.sine + flank.cosine) +
           profile.curvature * b * flank.sine * (tan_minus_angle(flank) + flank.tangent());
  };
  return boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0.0, end, 15, 1e-12);
}

double abel_depth_integral(const FlatFaced& profile, double lower, double upper, double r) {
  const double b = profile.flat_radius;
  lower = std::max(lower, b);
  if (upper <= lower) return 0;
  // With S = sqrt(x^2-b^2) = S_r sin(theta) = S_r cos(psi) the integral is that of (g/x) S dtheta: x itself, which has
  // few digits of its distance from b, does not occur. Each angle is accurate at one end.
  const auto root_at = [b](double x) { return std::sqrt((x - b) * (x + b)); };
  const auto other_root_at = [r](double x) { return std::sqrt((r - x) * (r + x)); };
  const auto integrand = [&](double root) { return root * image_over_x(profile, flank_with_root(profile, root)); };
  const double root_r = root_at(r);
  boost::math::quadrature::tanh_sinh<double> quadrature;
  if (root_at(upper) < other_root_at(upper)) {
    const auto theta = [&](double x) { return std::atan2(root_at(x), other_root_at(x)); };
    return quadrature.integrate([&](double t) { return integrand(root_r * std::sin(t)); }, theta(lower), theta(upper),
                                1e-13);
  }
  const auto psi = [&](double x) { return std::atan2(other_root_at(x), root_at(x)); };
  return quadrature.integrate([&](double t) { return integrand(root_r * std::cos(t)); }, psi(upper), psi(lower), 1e-13);
}

}  // namespace fretval::mdr
