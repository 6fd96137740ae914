#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "mdr/profiles/flat_faced.h"
#include "mdr/profiles/power_law.h"

// The profiles in fifty digits, where neither cancellation nor range is a concern. All formulas differ from those of
// the library: series of positive terms, closed forms that cancel, and plain Gauss rules.
namespace fretval::mdr {

using Wide = boost::multiprecision::cpp_bin_float_50;

inline const Wide wide_pi = boost::math::constants::pi<Wide>();

// 2F1(1, p; q; z) = sum (p)_k/(q)_k z^k for z <= 1/2.
inline Wide unit_hypergeometric(const Wide& p, const Wide& q, const Wide& z) {
  Wide term = 1, sum = 1;
  for (int k = 0; k < 600 && abs(term) > 1e-40 * abs(sum); ++k) {
    term *= (p + k) / (q + k) * z;
    sum += term;
  }
  return sum;
}

// Paper (3) for f = b r^n, with g = kappa b x^n.
struct WidePowerLaw {
  Wide b, n, kappa;

  explicit WidePowerLaw(const PowerLaw& profile)
      : b(profile.coefficient),
        n(profile.exponent),
        kappa(sqrt(wide_pi) / 2 * n * tgamma(n / 2) / tgamma((n + 1) / 2)) {}

  [[nodiscard]] Wide f(const Wide& r) const { return b * pow(r, n); }
  [[nodiscard]] Wide g(const Wide& x) const { return kappa * b * pow(x, n); }
  [[nodiscard]] Wide g_slope(const Wide& x) const { return n * g(x) / x; }
  [[nodiscard]] Wide g_integral(const Wide& x) const { return g(x) * x / (n + 1); }
  [[nodiscard]] Wide g_inverse(const Wide& d) const { return pow(d / (kappa * b), 1 / n); }

  // int_0^c g/sqrt(r^2-x^2) dx; Euler's transformation of the hypergeometric series at the nearer end.
  [[nodiscard]] Wide depth_integral_from_axis(const Wide& c, const Wide& r) const {
    const Wide cosine = c / r, sine = sqrt((r - c) * (r + c)) / r;
    if (cosine < sine)
      return g(r) * pow(cosine, n + 1) / (n + 1) * sine * unit_hypergeometric(n / 2 + 1, (n + 3) / 2, cosine * cosine);
    return g(r) * wide_pi / (2 * kappa) - depth_integral_to_edge(c, r);
  }

  // int_c^r g/sqrt(r^2-x^2) dx.
  [[nodiscard]] Wide depth_integral_to_edge(const Wide& c, const Wide& r) const {
    const Wide cosine = c / r, sine = sqrt((r - c) * (r + c)) / r;
    if (cosine < sine) return g(r) * wide_pi / (2 * kappa) - depth_integral_from_axis(c, r);
    return g(r) * sine * pow(cosine, n + 1) * unit_hypergeometric(n / 2 + 1, Wide(3) / 2, sine * sine);
  }

  // int_r^a g'/sqrt(x^2-r^2) dx; far from r the root is expanded in r/x.
  [[nodiscard]] Wide slope_integral(const Wide& r, const Wide& a) const {
    const Wide q = r / a;
    if (2 * q * q >= 0.999) return g_slope(a) * near_slope_integral(q);
    const Wide split = sqrt(Wide(2)) * q;
    Wide sum = pow(split, n - 1) * near_slope_integral(1 / sqrt(Wide(2)));
    Wide binomial = 1, power = pow(split, n - 1);
    for (int k = 0; k < 160; ++k) {
      const Wide m = n - 1 - 2 * k;
      sum += binomial * (m == 0 ? Wide(-log(split)) : Wide((1 - power) / m));
      binomial *= (k + Wide(0.5)) / (k + 1) * q * q;
      power /= split * split;
    }
    return g_slope(a) * sum;
  }

 private:
  [[nodiscard]] Wide near_slope_integral(const Wide& q) const {
    const Wide square = (1 - q) * (1 + q);
    return sqrt(square) * unit_hypergeometric(1 - n / 2, Wide(3) / 2, square);
  }
};

template <class Function>
Wide wide_gauss(const Function& function, const Wide& from, const Wide& to, const Wide& longest_panel) {
  const int n_panels = 1 + static_cast<int>((to - from) / longest_panel);
  Wide sum = 0;
  for (int k = 0; k < n_panels; ++k)
    sum += boost::math::quadrature::gauss<Wide, 30>::integrate(function, from + (to - from) * k / n_panels,
                                                               from + (to - from) * (k + 1) / n_panels);
  return sum;
}

// f = s (r - b) + (r - b)^2/(2 R) beyond b, with S = sqrt(x^2-b^2) and phi = arctan(S/b).
struct WideFlatFaced {
  Wide b, s, curvature;

  explicit WideFlatFaced(const FlatFaced& profile)
      : b(profile.flat_radius), s(profile.edge_slope), curvature(profile.curvature) {}

  [[nodiscard]] Wide root(const Wide& x) const { return sqrt((x - b) * (x + b)); }
  [[nodiscard]] Wide f(const Wide& r) const {
    if (r <= b) return 0;
    return (r - b) * (s + (r - b) * curvature / 2);
  }
  [[nodiscard]] Wide g(const Wide& x) const {
    if (x <= b) return 0;
    const Wide S = root(x), phi = atan(S / b);
    return x * (s * phi + curvature * (S - b * phi));
  }
  [[nodiscard]] Wide g_slope(const Wide& x) const {
    const Wide S = root(x), phi = atan(S / b);
    return s * (phi + b / S) + curvature * (2 * S - b * phi);
  }
  [[nodiscard]] Wide g_integral(const Wide& x) const {
    const Wide S = root(x), cap = (x * x * atan(S / b) - b * S) / 2;
    return s * cap + curvature * (S * S * S / 3 - b * cap);
  }

  // int_c^r g/sqrt(r^2-x^2) dx: the whole from b on is pi f(r)/2, the rest in u with S = b sinh(u).
  [[nodiscard]] Wide depth_integral_to_edge(const Wide& c, const Wide& r) const {
    if (c <= b) return wide_pi / 2 * f(r);
    const Wide S_c = root(c), S_r = root(r);
    const auto by_angle = [&](const Wide& t) -> Wide {
      const Wide S = S_r * sin(t), x = sqrt(S * S + b * b);
      return g(x) * S / x;
    };
    const auto by_u = [&](const Wide& u) -> Wide {
      const Wide S = b * sinh(u), x = b * cosh(u);
      return g(x) * S / sqrt((S_r - S) * (S_r + S));
    };
    if (2 * S_c >= S_r) return wide_gauss(by_angle, asin(S_c / S_r), wide_pi / 2, Wide(2));
    const Wide split = asin(Wide(1) / 2);
    return wide_gauss(by_u, asinh(S_c / b), asinh(S_r / (2 * b)), Wide(2)) +
           wide_gauss(by_angle, split, wide_pi / 2, Wide(2));
  }

  // int_r^a g'/sqrt(x^2-r^2) dx with S = delta cosh(u) outside the flat and delta sinh(u) below it.
  [[nodiscard]] Wide slope_integral(const Wide& r, const Wide& a) const {
    const Wide delta = sqrt(abs(r - b) * (r + b));
    const bool below = r < b;
    const auto by_u = [&](const Wide& u) -> Wide {
      const Wide S = delta * (below ? sinh(u) : cosh(u)), x = sqrt(S * S + b * b), phi = atan(S / b);
      return (s * (phi * S + b) + curvature * S * (2 * S - b * phi)) / x;
    };
    const Wide inner = below ? b : r;
    const Wide end = asinh(sqrt((a - inner) * (a + inner)) / delta);
    return wide_gauss(by_u, Wide(0), end, Wide(3));
  }
};

}  // namespace fretval::mdr
