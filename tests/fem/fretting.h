#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <complex>

#include "fem/ring_contact/static_contact.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem {

/// A parabola of radius of curvature 1, d0 = 0.8, normal amplitude 0.2: the contact radius is at most 1.
inline Motion fretting_motion() {
  return one_frequency(0.8, 0.2, 0, 0.0);
}

inline Eigen::VectorXd parabola_means(const ContactProblem& problem) {
  return ring_means(problem.compliance, [](double r) { return r * r / 2; });
}

/// Under this parabola, Hertz: `a = sqrt(d)`, `F = (16/3) d^1.5`.
inline StaticContact hertz_contact(const ContactProblem& problem, double indentation) {
  return static_contact(problem, parabola_means(problem), indentation);
}

/// Tractions of the rings under a unit displacement of the n innermost ones, the others free.
inline Eigen::VectorXd punch_traction(const ContactProblem& problem, Eigen::Index n) {
  const auto& [radii, areas, matrix, half_space] = problem.compliance;
  Eigen::VectorXd traction = Eigen::VectorXd::Zero(problem.n_rings());
  traction.head(n) = matrix->topLeftCorner(n, n).llt().solve(areas.head(n));
  return traction;
}

/// `|G(omega)| / G0` of the two viscoelastic bodies below.
constexpr double modulus_ratio = 1.5;

inline RelaxationModel elastic_body() {
  return {1, {}, {}, 0};
}

/// `|1 + g i/(1 + i)| = sqrt(1 + g + g^2/2) = 1.5`.
inline RelaxationModel standard_solid() {
  return {1, {std::sqrt(3.5) - 1}, {1}, 0};
}

/// `|1 + i eta| = 1.5`.
inline RelaxationModel kelvin_voigt() {
  return {1, {}, {}, std::sqrt(1.25)};
}

inline RelaxationModel three_branches() {
  return {1, {0.3, 0.2, 0.1}, {2, 0.5, 0.01}, 0};
}

inline std::complex<double> complex_modulus(const RelaxationModel& model) {
  std::complex<double> modulus(model.relaxed, model.viscosity);
  for (std::size_t i = 0; i < model.times.size(); ++i) {
    const std::complex<double> z(0, model.times[i]);
    modulus += model.moduli[i] * z / (1.0 + z);
  }
  return modulus;
}

}  // namespace fretval::fem
