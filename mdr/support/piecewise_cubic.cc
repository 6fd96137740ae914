#include "mdr/support/piecewise_cubic.h"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

namespace fretval::mdr {

namespace {

std::size_t piece_at(const PiecewiseCubic& cubic, double x) {
  const auto above = std::upper_bound(cubic.nodes.begin() + 1, cubic.nodes.end() - 1, x);
  return static_cast<std::size_t>(above - cubic.nodes.begin()) - 1;
}

double cubic_at(const std::array<double, 4>& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

template <class Function>
double gauss(const Function& function, double from, double to) {
  return boost::math::quadrature::gauss<double, 15>::integrate(function, from, to);
}

// Part of a piece and of its domain in an Abel integral.
struct Span {
  const std::array<double, 4>& coefficients;
  double start, lower, upper;
  [[nodiscard]] double at(double x) const { return cubic_at(coefficients, x - start); }
};

// int y/sqrt(r^2-x^2) over a span below r. The Gauss rule is good to roundoff wherever the nearest singularity is a
// length of the interval away: x = r, or after y^2 = r - x, which removes it, x = -r.
double span_below(const Span& span, double r) {
  const double lower = span.lower, upper = span.upper;
  if (upper - lower < r - upper)
    return gauss([&](double x) { return span.at(x) / std::sqrt((r - x) * (r + x)); }, lower, upper);
  return gauss([&](double y) { return 2 * span.at(r - y * y) / std::sqrt(2 * r - y * y); }, std::sqrt(r - upper),
               std::sqrt(r - lower));
}

// Coefficients of powers of x instead of x - start.
std::array<double, 4> about_zero(const std::array<double, 4>& c, double start) {
  return {c[0] - start * (c[1] - start * (c[2] - start * c[3])), c[1] - start * (2 * c[2] - 3 * start * c[3]),
          c[2] - 3 * start * c[3], c[3]};
}

// The closed form of the integral below, for a span not short against its distance from the axis.
double closed_span_above(const Span& span, double r) {
  const auto c = about_zero(span.coefficients, span.start);
  const double lower = span.lower, upper = span.upper;
  const double root_lower = std::sqrt((lower - r) * (lower + r));
  const double root_upper = std::sqrt((upper - r) * (upper + r));
  const double logarithm = std::log((upper + root_upper) / (lower + root_lower));
  const double squares = r > 0 ? r * r * logarithm : 0;
  const std::array<double, 4> moments{
      logarithm, root_upper - root_lower, (upper * root_upper - lower * root_lower + squares) / 2,
      (root_upper * (upper * upper + 2 * r * r) - root_lower * (lower * lower + 2 * r * r)) / 3};
  double sum = 0;
  for (std::size_t m = 0; m < 4; ++m) {
    if (c[m] != 0) sum += c[m] * moments[m];  // a zero may meet an infinite moment
  }
  return sum;
}

// int y/sqrt(x^2-r^2) over a span above r, as above with y^2 = x - r.
double span_above(const Span& span, double r) {
  const double lower = span.lower, upper = span.upper;
  if (upper - lower < lower - r)
    return gauss([&](double x) { return span.at(x) / std::sqrt((x - r) * (x + r)); }, lower, upper);
  if (upper < 2 * r)
    return gauss([&](double y) { return 2 * span.at(r + y * y) / std::sqrt(2 * r + y * y); }, std::sqrt(lower - r),
                 std::sqrt(upper - r));
  return closed_span_above(span, r);
}

template <class SpanIntegral>
double sum_of_spans(const PiecewiseCubic& cubic, double from, double to, const SpanIntegral& span_integral) {
  double sum = 0;
  for (std::size_t k = piece_at(cubic, from); k < cubic.coefficients.size(); ++k) {
    const bool last = k + 1 == cubic.coefficients.size();
    const double lower = std::max(from, cubic.nodes[k]), upper = last ? to : std::min(to, cubic.nodes[k + 1]);
    if (lower >= to) break;
    sum += span_integral(Span{cubic.coefficients[k], cubic.nodes[k], lower, upper});
  }
  return sum;
}

}  // namespace

PiecewiseCubic hermite_cubic(const std::vector<double>& nodes, const std::vector<double>& values,
                             const std::vector<double>& slopes) {
  PiecewiseCubic cubic{nodes, {}};
  for (std::size_t k = 0; k + 1 < nodes.size(); ++k) {
    const double h = nodes[k + 1] - nodes[k];
    const double secant = (values[k + 1] - values[k]) / h;
    cubic.coefficients.push_back({values[k], slopes[k], (3 * secant - 2 * slopes[k] - slopes[k + 1]) / h,
                                  (slopes[k] + slopes[k + 1] - 2 * secant) / (h * h)});
  }
  return cubic;
}

std::vector<double> monotone_slopes(const std::vector<double>& nodes, const std::vector<double>& values) {
  const std::size_t n = nodes.size();
  std::vector<double> h(n - 1), secant(n - 1), slopes(n);
  for (std::size_t k = 0; k + 1 < n; ++k) {
    h[k] = nodes[k + 1] - nodes[k];
    secant[k] = (values[k + 1] - values[k]) / h[k];
  }
  for (std::size_t k = 1; k + 1 < n; ++k) slopes[k] = (h[k] * secant[k - 1] + h[k - 1] * secant[k]) / (h[k - 1] + h[k]);
  slopes[0] = secant[0] + (secant[0] - slopes[1]);
  slopes[n - 1] = secant[n - 2] + (secant[n - 2] - slopes[n - 2]);
  const auto limited = [](double slope, double left, double right) {
    if (left * right < 0) return slope;
    const double sign = left > 0 ? 1 : -1;
    return sign * std::clamp(sign * slope, 0.0, 3 * std::min(std::abs(left), std::abs(right)));
  };
  for (std::size_t k = 0; k < n; ++k) {
    slopes[k] = limited(slopes[k], secant[k > 0 ? k - 1 : 0], secant[std::min(k, n - 2)]);
  }
  return slopes;
}

double value(const PiecewiseCubic& cubic, double x) {
  const std::size_t k = piece_at(cubic, x);
  return cubic_at(cubic.coefficients[k], x - cubic.nodes[k]);
}

PiecewiseCubic derivative(const PiecewiseCubic& cubic) {
  PiecewiseCubic result{cubic.nodes, {}};
  for (const auto& c : cubic.coefficients) result.coefficients.push_back({c[1], 2 * c[2], 3 * c[3], 0});
  return result;
}

double integral(const PiecewiseCubic& cubic, double x) {
  double sum = 0;
  for (std::size_t k = 0; k < cubic.coefficients.size() && cubic.nodes[k] < x; ++k) {
    const double t = std::min(x, cubic.nodes[k + 1]) - cubic.nodes[k];
    const auto& c = cubic.coefficients[k];
    sum += t * (c[0] + t * (c[1] / 2 + t * (c[2] / 3 + t * c[3] / 4)));
  }
  return sum;
}

double abel_integral_below(const PiecewiseCubic& cubic, double lower, double upper, double r) {
  return sum_of_spans(cubic, lower, upper, [r](const Span& span) { return span_below(span, r); });
}

double abel_integral_above(const PiecewiseCubic& cubic, double r, double a) {
  return sum_of_spans(cubic, r, a, [r](const Span& span) { return span_above(span, r); });
}

}  // namespace fretval::mdr
