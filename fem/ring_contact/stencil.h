#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace fretval::fem {

// Values of ring fields between their nodes, for the readings of forces and edges.

constexpr Eigen::Index n_stencil = 4;
constexpr Eigen::Index n_to_continue = 3;  // rings that tell where a zone ends

/// The polynomial through nodes first..first+n-1, in Newton's form. Without nodes it is zero.
class Stencil {
 public:
  template <class X, class Y>
  Stencil(const Eigen::MatrixBase<X>& x, const Eigen::MatrixBase<Y>& y, Eigen::Index first, Eigen::Index n) : n_(n) {
    for (Eigen::Index i = 0; i < n; ++i) {
      x_[i] = x[first + i];
      differences_[i] = y[first + i];
    }
    for (Eigen::Index order = 1; order < n; ++order)
      for (Eigen::Index i = n - 1; i >= order; --i)
        differences_[i] = (differences_[i] - differences_[i - 1]) / (x_[i] - x_[i - order]);
  }

  [[nodiscard]] Eigen::Index n_nodes() const { return n_; }
  [[nodiscard]] double first_node() const { return x_[0]; }
  [[nodiscard]] double last_node() const { return x_[n_ - 1]; }

  double operator()(double at) const {
    double value = 0;
    for (Eigen::Index i = n_ - 1; i >= 0; --i) value = value * (at - x_[i]) + differences_[i];
    return value;
  }

  /// Integral of the polynomial, exact up to degree 3.
  [[nodiscard]] double integral(double from, double to) const {
    const double middle = (from + to) / 2, offset = (to - from) / (2 * std::sqrt(3.0));
    return (to - from) / 2 * ((*this)(middle - offset) + (*this)(middle + offset));
  }

 private:
  static constexpr Eigen::Index most_nodes = 8;
  Eigen::Index n_;
  double x_[most_nodes], differences_[most_nodes];
};

/// y at a place among the x, which rise, by the cubic through the nearest four.
inline double interpolated(const Eigen::VectorXd& x, const Eigen::VectorXd& y, double at) {
  const Eigen::Index n = std::min<Eigen::Index>(n_stencil, x.size()),
                     above = std::upper_bound(x.begin(), x.end(), at) - x.begin();
  return Stencil{x, y, std::clamp<Eigen::Index>(above - n / 2, 0, x.size() - n), n}(at);
}

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

/// Where f changes its sign between two nodes, or hardly beyond them: at the instant at which a ring changes its zone,
/// roundoff decides on which side of its node the crossing lies.
template <class Function>
std::optional<double> crossing(const Function& f, double node, double next) {
  const double slack = 0.1 * (next - node);
  return root_between(f, node - slack, next + slack);
}

/// Where the polynomials of two neighbouring zones meet.
inline std::optional<double> meeting_point(const Stencil& inner, const Stencil& outer) {
  return crossing([&](double r) { return inner(r) - outer(r); }, inner.last_node(), outer.first_node());
}

}  // namespace fretval::fem
