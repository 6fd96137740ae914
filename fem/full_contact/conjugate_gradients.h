#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace fretval::fem {

// Common to the two solvers that conjugate gradients serve, friction_solver.h and normal_solver.h.

/// Natural residual at which a solution is good enough, over its largest limit or pressure: roundoff leaves 1e-14.
constexpr double enough_of_contact = 1e-11;
constexpr int most_newton_steps = 200, most_applications = 200;

/// Share of its right-hand side to which a linear system is solved while the remainder of the whole problem is this
/// large, and `enough` is asked for: not smaller than the next step of Newton's method can make use of (Dembo,
/// Eisenstat and Steihaug 1982), and no further below what is asked for than by a half.
inline double share_for(double remainder, double enough) {
  return std::min(std::max({remainder, 1e-6, enough / remainder / 2}), 0.05);
}

/// Preconditioned conjugate gradients for `A x = b` on fields, from x = 0, until the preconditioned residual is below a
/// share of that of b, or after most_applications. apply and precondition: (field, result), symmetric positive definite
/// on the space that they map into, in which b lies. The number of applications is returned. (Hestenes and Stiefel
/// 1952; Nocedal and Wright, Numerical Optimization, algorithm 5.3.)
template <class Apply, class Precondition>
int conjugate_gradients(const Apply& apply, const Precondition& precondition, Eigen::MatrixXd b, double share,
                        int most_applications, Eigen::MatrixXd& x) {
  const auto product = [](const Eigen::MatrixXd& a, const Eigen::MatrixXd& c) { return a.cwiseProduct(c).sum(); };
  Eigen::MatrixXd z, image;
  x.setZero(b.rows(), b.cols());
  precondition(b, z);
  Eigen::MatrixXd direction = z;
  double size = product(b, z);
  const double enough = share * share * size;
  int n = 0;
  while (size > enough && n < most_applications) {
    apply(direction, image);
    ++n;
    const double length = size / product(direction, image);
    if (!std::isfinite(length)) break;
    x += length * direction;
    b -= length * image;
    precondition(b, z);
    const double size_before = size;
    size = product(b, z);
    direction = z + size / size_before * direction;
  }
  return n;
}

}  // namespace fretval::fem
