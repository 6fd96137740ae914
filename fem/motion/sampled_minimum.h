#pragma once

#include <algorithm>
#include <cmath>

namespace fretval::fem {

/// Minimum of a signal next to the middle one of five samples, which is the smallest of the inner three. The samples at
/// -2, ..., 2 by their central differences (Stirling): f0 + x s + x^2/2 c + x (x^2 - 1)/6 t + x^2 (x^2 - 1)/24 q.
struct SampledMinimum {
  double f0, s, c, t, q;

  SampledMinimum(double a, double b, double f, double d, double e)
      : f0(f), s((d - b) / 2), c(d - 2 * f + b), t((e - 2 * d + 2 * b - a) / 2), q(e - 4 * d + 6 * f - 4 * b + a) {}

  /// Whether third and fourth differences are less than half of the second.
  [[nodiscard]] bool smooth() const { return std::abs(t) < c / 2 && std::abs(q) < c / 2; }
  [[nodiscard]] double vertex_of_parabola() const { return c > 0 ? f0 - s * s / (2 * c) : f0; }

  [[nodiscard]] double minimum_of_quartic() const {
    constexpr int enough_iterations = 4;
    double x = -s / c;
    for (int k = 0; k < enough_iterations; ++k) {
      const double slope = s + x * c + (3 * x * x - 1) / 6 * t + x * (2 * x * x - 1) / 12 * q;
      x = std::clamp(x - slope / (c + x * t + (6 * x * x - 1) / 12 * q), -1.0, 1.0);
    }
    const double rest = x * x - 1;
    return f0 + x * s + x * x / 2 * c + x * rest / 6 * t + x * x * rest / 24 * q;
  }
};

}  // namespace fretval::fem
