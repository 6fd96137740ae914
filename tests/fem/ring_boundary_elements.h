#pragma once

#include <Eigen/Dense>
#include <cmath>

namespace fretval::fem {

/// Boundary elements for the incompressible half-space of unit shear modulus, which know nothing of the finite ones:
/// rings of constant pressure, the displacement at their middles from the point load, `u = 1/(pi E*) int p dA/|r-r'|`,
/// E* = 4:
///
///   u(r) = 1/pi int p(s) s/(r+s) K(k) ds,   k^2 = 4 r s/(r+s)^2
struct RingBoundaryElements {
  Eigen::VectorXd middle, areas;
  Eigen::MatrixXd matrix;  ///< displacements per pressure

  RingBoundaryElements(double end, int n) : middle(n), areas(n), matrix(n, n) {
    const double h = end / n;
    for (int i = 0; i < n; ++i) {
      middle[i] = (i + 0.5) * h;
      areas[i] = 2 * std::acos(-1.0) * middle[i] * h;
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) matrix(i, j) = ring(middle[i], j * h, (j + 1) * h);
  }

  /// The least pressures that leave no gap negative, by projected Gauss-Seidel.
  [[nodiscard]] Eigen::VectorXd pressures(const Eigen::VectorXd& target) const {
    Eigen::VectorXd p = Eigen::VectorXd::Zero(target.size());
    for (int sweep = 0; sweep < 20000; ++sweep) {
      double change = 0;
      for (Eigen::Index i = 0; i < p.size(); ++i) {
        const double next = std::max(0.0, p[i] + (target[i] - matrix.row(i).dot(p)) / matrix(i, i));
        change = std::max(change, std::abs(next - p[i]));
        p[i] = next;
      }
      if (change < 1e-11) break;
    }
    return p;
  }

 private:
  /// K(k) = pi / (2 agm(1, k')), k' = |r - s|/(r + s), which does not round to a singularity next to r.
  static double kernel(double r, double s) {
    double a = 1, b = std::abs(r - s) / (r + s);
    while (a - b > 1e-15 * a) {
      const double mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
    }
    return s / (r + s) / (2 * a);
  }

  /// Next to its logarithmic singularity in halves, towards it.
  static double ring(double r, double inner, double outer) {
    if (r <= inner || r >= outer) return gauss(r, inner, outer);
    double sum = 0, left = r - inner, right = outer - r;
    for (int k = 0; k < 30; ++k, left /= 2, right /= 2)
      sum += gauss(r, r - left, r - left / 2) + gauss(r, r + right / 2, r + right);
    return sum;
  }

  static double gauss(double r, double from, double to) {
    static constexpr double x[4] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
    static constexpr double w[4] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
    double sum = 0;
    for (int q = 0; q < 4; ++q) sum += w[q] * kernel(r, (from + to) / 2 + x[q] * (to - from) / 2);
    return sum * (to - from) / 2;
  }
};

}  // namespace fretval::fem
