#include "comparison/verification/exact/exact_rows.h"
#include "fem/ring_contact/effective_radii.h"
#include "mdr/profiles/indentation.h"
#include "mdr/springs/spring_energy.h"

namespace fretval {
namespace {

/// `f = b r^n` with the exact solution of mdr/profiles/indentation.h, and b such that the contact radius is 1 at the
/// indentation 1.
struct Indenter {
  const char *name, *source;
  double exponent;
  ConvergenceDemand radius, force;
};

/// Contact radius and force, for contact radii from 0.8 to 1.
Rows indenter_rows(const Meshes& meshes, const Indenter& indenter, const ExactScene& exact) {
  const auto steep = [&](double steepness) {
    return mdr::power_law(steepness / mdr::transform_factor(indenter.exponent), indenter.exponent);
  };
  const auto shape = steep(1), exact_shape = steep(exact.steepness);
  std::vector<double> indentations;
  for (int k = 0; k < n_positions; ++k) indentations.push_back(mdr::transform(shape, position(k, 0.8, 1)));
  const auto known = [&](double d) {
    return RadiusAndForce{mdr::contact_radius(exact_shape, d), mdr::normal_force(exact_shape, exact.modulus, d)};
  };
  const auto errors = [&](const ConvergenceMesh& mesh) { return static_errors(mesh, shape, indentations, known); };
  return mesh_rows(Rows{{indenter.name, "contact radius", indenter.source, indenter.radius},
                        {indenter.name, "force", indenter.source, indenter.force}},
                   meshes, errors);
}

/// Force of a unit displacement of the n innermost rings.
double force_of_stuck_rings(const fem::ContactProblem& problem, Eigen::Index n) {
  const auto& compliance = problem.compliance;
  const Eigen::VectorXd areas = compliance.areas.head(n);
  return areas.dot(compliance.matrix->topLeftCorner(n, n).llt().solve(areas));
}

/// Force of the rings inside r = 1 at a unit displacement, for their nominal and for their effective radius
/// (fem/ring_contact/effective_radii.h): normal without friction, `8 G a`, or tangential and sticking, `(16/3) G a`.
Rows punch_rows(const Meshes& meshes, bool is_normal, const ExactScene& exact) {
  const char* name = is_normal ? "flat punch" : "full stick";
  const char* source = is_normal ? "Boussinesq 1885, Sneddon 1965" : "Mindlin 1949";
  const auto body = mdr::elastic(exact.modulus);
  const double exact_force = is_normal ? mdr::normal_scale(body) : mdr::tangential_scale(body);
  const auto errors = [&](const ConvergenceMesh& mesh) {
    const auto& problem = is_normal ? mesh.normal : mesh.tangential;
    const double force = force_of_stuck_rings(problem, mesh.n_rings) / exact_force;
    return std::vector<double>{force - 1, force / fem::effective_radii(problem.compliance).radius[mesh.n_rings] - 1};
  };
  const char* nominal_note = "n rings act like a disc 0.1 to 0.15 rings smaller: read at the effective radius below";
  return mesh_rows(Rows{{name, "force", source, {2e-3, 1, far_field, nominal_note}},
                        {name, "force over effective radius", source, {1e-6, 3, 2 * far_field, far_field_note}}},
                   meshes, errors);
}

}  // namespace

Rows indentation_rows(const Meshes& meshes, const ExactScene& exact) {
  const ConvergenceDemand radius{1e-6, 3, far_field, far_field_note};
  Rows rows;
  for (const auto& indenter :
       {Indenter{"Hertz", "Hertz 1882, Johnson 1985", 2, radius, {1e-6, 3, bulk_floor, bulk_note}},
        Indenter{"cone", "Love 1939, Sneddon 1965", 1, radius, {1e-5, 2, far_field, "the ring at the tip: h^2"}},
        Indenter{"power law n = 4", "Galin 1946, Sneddon 1965", 4, radius, {6e-6, 2, far_field, far_field_note}}})
    append(rows, indenter_rows(meshes, indenter, exact));
  for (const bool is_normal : {true, false}) append(rows, punch_rows(meshes, is_normal, exact));
  return rows;
}

}  // namespace fretval
