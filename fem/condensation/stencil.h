#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <optional>

namespace fretval::fem {

// Fields of rings between their nodes. For the readings of forces and edges alone.

constexpr Eigen::Index n_stencil = 4;
constexpr Eigen::Index n_to_continue = 3;  // rings that tell where a zone ends

/// The polynomial through nodes first..first+n-1.
struct Stencil {
  const Eigen::VectorXd& x;
  const Eigen::VectorXd& y;
  Eigen::Index first, n;

  double operator()(double at) const {
    double value = 0;
    for (Eigen::Index i = first; i < first + n; ++i) {
      double weight = 1;
      for (Eigen::Index j = first; j < first + n; ++j)
        if (j != i) weight *= (at - x[j]) / (x[i] - x[j]);
      value += weight * y[i];
    }
    return value;
  }

  /// Exact: the polynomial is a cubic at most.
  [[nodiscard]] double integral(double from, double to) const {
    const double middle = (from + to) / 2, offset = (to - from) / (2 * std::sqrt(3.0));
    return (to - from) / 2 * ((*this)(middle - offset) + (*this)(middle + offset));
  }
};

/// Where f changes its sign between low and high, by bisection.
template <class Function>
std::optional<double> root_between(const Function& f, double low, double high) {
  const double at_low = f(low);
  if (!(at_low * f(high) < 0)) return std::nullopt;
  while (high - low > 1e-14 * high) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    ((f(middle) < 0) == (at_low < 0) ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Where f changes its sign between two nodes, or hardly beyond: at the instant at which a ring changes its zone,
/// roundoff decides on which side of its node.
template <class Function>
std::optional<double> crossing(const Function& f, double node, double next) {
  const double slack = 0.1 * (next - node);
  return root_between(f, node - slack, next + slack);
}

/// Where the polynomials of two neighbouring zones meet.
inline std::optional<double> meeting_point(const Stencil& inner, const Stencil& outer) {
  return crossing([&](double r) { return inner(r) - outer(r); }, inner.x[inner.first + inner.n - 1],
                  outer.x[outer.first]);
}

}  // namespace fretval::fem
