#pragma once

#include <array>
#include <vector>

namespace fretval::mdr {

/// Piecewise polynomial of degree three or less: between nodes[k] and nodes[k+1] it is sum_m c[k][m] (x - nodes[k])^m.
/// Abel integrals of such a polynomial are sums over its pieces, each good to roundoff, the end singularity of the
/// kernel included.
struct PiecewiseCubic {
  std::vector<double> nodes;                        ///< increasing, first one 0
  std::vector<std::array<double, 4>> coefficients;  ///< one less than nodes
};

/// The piecewise cubic with these values and slopes at the nodes.
PiecewiseCubic hermite_cubic(const std::vector<double>& nodes, const std::vector<double>& values,
                             const std::vector<double>& slopes);

/// Slopes at the nodes for a Hermite cubic through values: of the parabola through a node and its neighbours, so exact
/// for quadratics, limited to three times the smaller neighbouring secant where the values are monotone, so that the
/// cubic is monotone there too. Source: Fritsch and Carlson, SIAM Journal on Numerical Analysis 17 (1980) 238; Hyman,
/// SIAM Journal on Scientific and Statistical Computing 4 (1983) 645. At least three nodes.
std::vector<double> monotone_slopes(const std::vector<double>& nodes, const std::vector<double>& values);

/// Value at nodes.front() <= x <= nodes.back(); beyond, the end pieces go on.
double value(const PiecewiseCubic& cubic, double x);

/// Derivative, a piecewise quadratic.
PiecewiseCubic derivative(const PiecewiseCubic& cubic);

/// Integral of the cubic from 0 to x.
double integral(const PiecewiseCubic& cubic, double x);

/// int y(x)/sqrt(r^2-x^2) dx from lower to upper, 0 <= lower <= upper <= r and upper <= nodes.back().
double abel_integral_below(const PiecewiseCubic& cubic, double lower, double upper, double r);

/// int_r^a y(x)/sqrt(x^2-r^2) dx for 0 <= r <= a <= nodes.back(); infinite for r = 0 unless y(0) = 0.
double abel_integral_above(const PiecewiseCubic& cubic, double r, double a);

}  // namespace fretval::mdr
