#include "comparison/simulation/body.h"
#include "comparison/verification/exact/exact_rows.h"
#include "fem/condensation/contact_events.h"
#include "fem/condensation/effective_radii.h"
#include "fem/history/contact_force.h"
#include "fem/stick_zone/contact_radius.h"
#include "mdr/profiles/indentation.h"
#include "mdr/springs/spring_energy.h"
#include "meshes/grading.h"

namespace fretval {

std::vector<ConvergenceMesh> half_space_meshes(const std::vector<int>& n_rings) {
  std::vector<ConvergenceMesh> meshes;
  for (const int n : n_rings) {
    Body body = make_body({meshes::uniform_nodes(1.125, static_cast<unsigned>(n) * 9 / 8), 0.15, 25, 3});
    meshes.push_back({n, std::move(body.normal.contact), std::move(body.tangential->contact)});
  }
  return meshes;
}

ExactIndentation exact_indentation(const std::string& name, const std::string& source, double exponent) {
  const auto profile = mdr::power_law(1 / mdr::transform_factor(exponent), exponent);
  return {name, source, profile, [profile](double d) { return mdr::contact_radius(profile, d); },
          [profile](double d) { return mdr::normal_force(profile, 1, d); }};
}

std::vector<ConvergenceRow> indentation_rows(const std::vector<ConvergenceMesh>& meshes, const ExactIndentation& exact,
                                             const ConvergenceDemand& radius, const ConvergenceDemand& force) {
  const auto errors = [&](const ConvergenceMesh& mesh) {
    const Eigen::VectorXd profile = means_of(exact.profile, mesh.normal);
    const auto events = fem::contact_events(mesh.normal.compliance, profile);
    double radius_error = 0, force_error = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double indentation = mdr::transform(exact.profile, position(k, 0.8, 1));
      const auto contact = fem::static_contact(mesh.normal, profile, indentation);
      const double contact_radius = fem::largest_contact_radius(contact.gap, events).radius;
      const double contact_force = fem::contact_force(mesh.normal.series, contact.pressure, contact.gap).force;
      take_worst(radius_error, contact_radius / exact.contact_radius(indentation) - 1);
      take_worst(force_error, contact_force / exact.force(indentation) - 1);
    }
    return std::vector<double>{radius_error, force_error};
  };
  return mesh_rows({{exact.name, "contact radius", exact.source, radius}, {exact.name, "force", exact.source, force}},
                   meshes, errors);
}

namespace {

/// Force of a unit displacement of the n innermost rings.
double force_of_stuck_rings(const fem::ContactProblem& problem, Eigen::Index n) {
  const auto& compliance = problem.compliance;
  const Eigen::VectorXd areas = compliance.areas.head(n);
  return areas.dot(compliance.matrix.topLeftCorner(n, n).llt().solve(areas));
}

}  // namespace

ExactPunch exact_punch() {
  const auto body = mdr::elastic(1);
  return {mdr::normal_scale(body), mdr::tangential_scale(body)};
}

std::vector<ConvergenceRow> punch_rows(const std::vector<ConvergenceMesh>& meshes, const ExactPunch& exact) {
  struct Punch {
    const char *name, *source;
    bool normal;
    double force;
  };
  const ConvergenceDemand nominal{
      2e-3, 1, far_field, std::nullopt,
      "n rings act like a disc 0.1 to 0.15 rings smaller: read at the effective radius below"};
  const ConvergenceDemand effective{1e-6, 3, 2 * far_field, 1e-5, far_field_note};
  std::vector<ConvergenceRow> rows;
  for (const auto& punch : {Punch{"flat punch", "Boussinesq 1885, Sneddon 1965", true, exact.normal},
                            Punch{"full stick", "Mindlin 1949", false, exact.tangential}}) {
    const auto errors = [&](const ConvergenceMesh& mesh) {
      const auto& problem = punch.normal ? mesh.normal : mesh.tangential;
      const double force = force_of_stuck_rings(problem, mesh.n_rings) / punch.force;
      return std::vector<double>{force - 1, force / fem::effective_radii(problem.compliance).radius[mesh.n_rings] - 1};
    };
    for (auto& row : mesh_rows({{punch.name, "force", punch.source, nominal},
                                {punch.name, "force over effective radius", punch.source, effective}},
                               meshes, errors))
      rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace fretval
