#include "mdr/support/gauss_legendre.h"

#include <cmath>
#include <stdexcept>

#include "mdr/support/checks.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

struct Legendre {
  double value, slope;
};

Legendre legendre(int n, double x) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (before - x * value) / ((1 - x) * (1 + x))};
}

QuadratureRule on_unit_interval(int n) {
  constexpr int newton_steps = 8;  // the guess has two digits, each step doubles them
  QuadratureRule rule{Eigen::ArrayXd(n), Eigen::ArrayXd(n)};
  for (int j = 0; j < n; ++j) {
    double x = -std::cos(pi * (j + 0.75) / (n + 0.5));
    for (int step = 0; step < newton_steps; ++step) {
      const Legendre at = legendre(n, x);
      x -= at.value / at.slope;
    }
    const double slope = legendre(n, x).slope;
    rule.point[j] = x;
    rule.weight[j] = 2 / ((1 - x) * (1 + x) * slope * slope);
  }
  return rule;
}

}  // namespace

QuadratureRule gauss_legendre(const std::vector<double>& breaks, int n_points) {
  require_within("points of a panel", n_points, 1, 200);
  if (breaks.size() < 2) throw std::invalid_argument("number of breaks: must be at least 2");
  const QuadratureRule unit = on_unit_interval(n_points);
  const auto n_panels = static_cast<Eigen::Index>(breaks.size()) - 1;
  QuadratureRule rule{Eigen::ArrayXd(n_panels * n_points), Eigen::ArrayXd(n_panels * n_points)};
  for (Eigen::Index k = 0; k < n_panels; ++k) {
    const double lower = breaks[static_cast<std::size_t>(k)],
                 half = (breaks[static_cast<std::size_t>(k) + 1] - lower) / 2;
    require_positive("length of a panel", 2 * half);
    rule.point.segment(k * n_points, n_points) = lower + half * (1 + unit.point);
    rule.weight.segment(k * n_points, n_points) = half * unit.weight;
  }
  return rule;
}

}  // namespace fretval::mdr
