#pragma once

#include <Eigen/Core>
#include <vector>

namespace fretval::mdr {

/// Points and weights of an integral over an interval, int f dx = sum(weight f(point)).
struct QuadratureRule {
  Eigen::ArrayXd point, weight;
};

/// Gauss and Legendre on panels between rising breaks, at least two, with n_points in each; points rise. On a panel of
/// length l an integrand that is analytic within the ellipse of foci at its ends and half axes l/2 (b +- 1/b)/2 errs by
/// about b^(-2 n_points). n_points from 1 to 200. Throws std::invalid_argument for bad arguments.
QuadratureRule gauss_legendre(const std::vector<double>& breaks, int n_points);

}  // namespace fretval::mdr
