#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <memory>
#include <vector>

#include "fem/ring_contact/effective_radii.h"
#include "tests/fem/half_space.h"

namespace fretval::fem {

/// A half-space whose surface a pressure p moves by s (r² ∫ p dA + ∫ p r² dA) more, a smooth kernel like that of the
/// base of a layer, which displacements of flat punches and paraboloids solve in closed form.
class StiffenedHalfSpace {
 public:
  explicit StiffenedHalfSpace(unsigned n_per_radius)
      : compliance_(normal_half_space(n_per_radius).compliance),
        force_per_radius_(force_of(compliance_, n_per_radius) / effective_radii(compliance_).radius[n_per_radius]) {
    compliance_.half_space = std::make_shared<const Compliance>(compliance_);
    const auto& areas = compliance_.areas;
    Eigen::VectorXd square(areas.size());
    for (Eigen::Index i = 0; i < areas.size(); ++i)
      square[i] = areas[i] * (std::pow(compliance_.radii[i], 2) + std::pow(compliance_.radii[i + 1], 2)) / 2;
    compliance_.matrix =
        SharedMatrix(*compliance_.matrix + smooth * (square * areas.transpose() + areas * square.transpose()));
  }

  [[nodiscard]] const Compliance& compliance() const { return compliance_; }

  /// Of a unit indentation by a flat punch: a half-space under one by 1 - s (M + F r²), M = ∫ p r² dA, of which MDR
  /// makes F = k ((1 - s M) R - 2 s F R³/3) and M = k ((1 - s M) 2 R³/3 - 4 s F R⁵/5).
  [[nodiscard]] double punch_force(double radius) const {
    const double k = force_per_radius_, r3 = 2 * std::pow(radius, 3) / 3, r5 = 4 * std::pow(radius, 5) / 5;
    const Eigen::Matrix2d left{{1 + k * smooth * r3, k * smooth * radius}, {k * smooth * r5, 1 + k * smooth * r3}};
    return Eigen::Vector2d(left.partialPivLu().solve(Eigen::Vector2d(k * radius, k * r3)))[0];
  }

  /// Under r²/2, which seems to be (1/2 + s F) r²: d - s M = (1 + 2 s F) a², F = 2k/3 (1 + 2 s F) a³,
  /// M = 4k/15 (1 + 2 s F) a⁵.
  [[nodiscard]] double indentation_of_parabola(double contact_radius) const {
    const double k = force_per_radius_, cube = 2 * k / 3 * std::pow(contact_radius, 3),
                 force = cube / (1 - 2 * smooth * cube), steeper = 1 + 2 * smooth * force;
    return steeper * (std::pow(contact_radius, 2) + smooth * 4 * k / 15 * std::pow(contact_radius, 5));
  }

 private:
  static constexpr double smooth = -0.02;
  static double force_of(const Compliance& compliance, Eigen::Index n) {
    const Eigen::VectorXd areas = compliance.areas.head(n);
    return areas.dot(compliance.matrix->topLeftCorner(n, n).llt().solve(areas));
  }
  Compliance compliance_;
  double force_per_radius_;
};

}  // namespace fretval::fem
