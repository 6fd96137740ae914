#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <tuple>

#include "fem/full_contact/coupled_contact.h"
#include "fem/full_contact/surface_compliance.h"
#include "fem/full_contact/vector_friction.h"
#include "fem/ring_contact/static_contact.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::full_contact_test {

/// A half-space of unit shear modulus with a contact line of length 1.125 and n_per_radius rings per unit length, cut
/// off at 25, with as many Fourier orders as 8 angles draw on, or fewer. Built once a process.
inline const SurfaceCompliance& surface_half_space(double poisson_ratio, unsigned n_per_radius = 8,
                                                   unsigned highest_order = 5) {
  static std::map<std::tuple<double, unsigned, unsigned>, SurfaceCompliance> bodies;
  const auto key = std::make_tuple(poisson_ratio, n_per_radius, highest_order);
  auto found = bodies.find(key);
  if (found == bodies.end()) {
    auto grid = quarter_disc_grid(1.125, n_per_radius * 9 / 8, 25, 0.25);
    grid.elasticity.poisson_ratio = poisson_ratio;
    found = bodies.emplace(key, surface_compliance(grid, highest_order)).first;
  }
  return found->second;
}

/// Areas times the displacements by tractions and pressures at once, fields with columns for t_x, t_y and p.
inline Eigen::MatrixXd response(const CoupledOperators& operators, const Eigen::MatrixXd& fields) {
  const Eigen::Index m = operators.normal.n_columns();
  Eigen::MatrixXd along, into, all(fields.rows(), fields.cols());
  operators.tangential.apply(fields.leftCols(2 * m), along);
  operators.normal.apply(fields.rightCols(m), into);
  all << along + operators.coupling.along_surface(fields.rightCols(m)),
      into + operators.coupling.into_body(fields.leftCols(2 * m));
  return all;
}

/// Ring means of Hertz's pressure p0 sqrt(1 - r^2) over a unit disc.
inline Eigen::VectorXd hertz_pressure(const SurfaceCompliance& surface, double p0 = 1) {
  const auto volume_beyond = [](double r) { return r < 1 ? std::pow(1 - r * r, 1.5) / 3 : 0; };
  Eigen::VectorXd pressure(surface.n_rings());
  for (Eigen::Index i = 0; i < pressure.size(); ++i) {
    const double inner = surface.radii[i], outer = surface.radii[i + 1];
    pressure[i] = p0 * (volume_beyond(inner) - volume_beyond(outer)) * 2 / (outer * outer - inner * inner);
  }
  return pressure;
}

/// Push along x at which Hertz's pressure leaves a stick radius c over a half-space, by Cattaneo (Johnson, Contact
/// Mechanics, 7.2), for unit p0, contact radius, shear modulus and friction coefficient.
inline double cattaneo_push(double c, double poisson_ratio) {
  return 3 * (2 * pi / 3) * (2 - poisson_ratio) / 16 * (1 - c * c);
}

inline ValueAndRate nowhere(double, double) {
  return {0, 0};
}

/// From one place to another within a cycle.
inline Course ramp(double from, double to) {
  return [=](double t, double) { return ValueAndRate{from + (to - from) * t / (2 * pi), (to - from) / (2 * pi)}; };
}

/// Ring means of r^exponent.
inline Eigen::MatrixXd round_profile(const SurfaceCompliance& surface, double exponent, Eigen::Index n_angles) {
  const auto rings = ring_compliance(surface, axisymmetric);
  return ring_means(rings, [=](double r) { return std::pow(r, exponent); }).replicate(1, n_angles);
}

}  // namespace fretval::fem::full_contact_test
