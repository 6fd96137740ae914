#include <fmt/format.h>

#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "mdr/layer/layer.h"
#include "mdr/profiles/indentation.h"

namespace fretval {
namespace {

/// Spring moduli of a half-space of any nu, without coupling of normal and tangential contact: E* = 2 G/(1 - nu), G* =
/// 4 G/(2 - nu), and mu E*/G* (d - g(c)) as the displacement that leaves c stuck.
struct ExactModuli {
  double normal, tangential;

  ExactModuli(double shear_modulus, double poisson_ratio)
      : normal(shear_modulus * mdr::spring_modulus(mdr::Direction::normal, poisson_ratio)),
        tangential(shear_modulus * mdr::spring_modulus(mdr::Direction::tangential, poisson_ratio)) {}
};

/// The contact radius is 1 at the indentation 1.
mdr::Profile parabola_of(double steepness = 1) {
  return mdr::parabola(1 / steepness);
}

/// Contact radius and force, for contact radii from 0.8 to 1.
std::vector<double> errors_of_hertz(const ConvergenceMesh& mesh, const ExactModuli& moduli, const ExactScene& exact) {
  std::vector<double> indentations;
  for (int k = 0; k < n_positions; k += 4) indentations.push_back(std::pow(position(k, 0.8, 1), 2));
  const auto known = parabola_of(exact.steepness);
  return static_errors(mesh, parabola_of(), indentations, [&](double d) {
    return RadiusAndForce{mdr::contact_radius(known, d), mdr::normal_force(known, moduli.normal / 4, d)};
  });
}

/// Error of the force on all rings inside r = 1 that move together, at their effective radius: 2 E* a, 2 G* a.
double error_of_punch(const fem::ContactProblem& problem, int n_rings, double modulus) {
  return problem.series.punch_force(n_rings) / (2 * modulus * problem.series.edges()[n_rings]) - 1;
}

/// Cattaneo and Mindlin, for stick radii from 0.3 to 0.9.
double error_of_push(const ConvergenceMesh& mesh, double poisson_ratio, const ExactScene& exact) {
  const auto contact = fem::static_contact(mesh.normal, means_of(parabola_of(), mesh.normal), 1);
  double error = 0;
  for (int k = 0; k < n_positions; k += 4) {
    const double radius = position(k, 0.3, 0.9);
    const double displacement = exact.friction_coefficient * mdr::spring_modulus_ratio(poisson_ratio) *
                                (1 - mdr::transform(parabola_of(exact.steepness), radius));
    take_worst(error, stick_radius_of_push(mesh, contact.pressure, displacement) - radius);
  }
  return error;
}

Rows rows_of(double poisson_ratio, const std::vector<int>& n_rings, const ExactScene& exact) {
  const auto name = fmt::format("half-space ν = {:g}", poisson_ratio);
  // The condition on the far hemisphere lacks, for a compressible body, the term of the third power of the distance
  // that it has for an incompressible one.
  constexpr double far_radius = 100, far_field_of_compressible = 5e-7;
  const ConvergenceDemand radius{1e-6, 3, far_field_of_compressible, far_field_note},
      force{1e-6, 3, bulk_floor, bulk_note}, stick{5e-6, 3, far_field_of_compressible, far_field_note};
  const Rows rows{{name, "contact radius", "Hertz 1882", radius},
                  {name, "force", "Hertz 1882", force},
                  {name, "flat punch", "Boussinesq 1885, Sneddon 1965", force},
                  {name, "full stick", "Mindlin 1949", force},
                  {name, "stick radius of a push", "Cattaneo 1938, Mindlin 1949", stick}};
  const ExactModuli moduli(exact.modulus, poisson_ratio);
  return mesh_rows(rows, half_space_meshes(n_rings, poisson_ratio, far_radius), [&](const ConvergenceMesh& mesh) {
    auto errors = errors_of_hertz(mesh, moduli, exact);
    errors.push_back(error_of_punch(mesh.normal, mesh.n_rings, moduli.normal));
    errors.push_back(error_of_punch(mesh.tangential, mesh.n_rings, moduli.tangential));
    errors.push_back(error_of_push(mesh, poisson_ratio, exact));
    return errors;
  });
}

}  // namespace

Rows poisson_rows(const std::vector<int>& n_rings, const ExactScene& exact) {
  Rows rows;
  for (const double poisson_ratio : {0.0, 0.3, 0.45, 0.4999}) append(rows, rows_of(poisson_ratio, n_rings, exact));
  return rows;
}

}  // namespace fretval
