#include "comparison/simulation/body.h"
#include "comparison/verification/exact/exact_space_rows.h"
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
  const auto worst = [&](const ConvergenceMesh& mesh, const auto& error_of) {
    const Eigen::VectorXd profile = means_of(exact.profile, mesh.normal);
    double error = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double indentation = mdr::transform(exact.profile, position(k, 0.8, 1));
      take_worst(error, error_of(fem::static_contact(mesh.normal, profile, indentation), indentation));
    }
    return error;
  };
  const auto radius_error = [&](const ConvergenceMesh& mesh) {
    const auto events = fem::contact_events(mesh.normal.compliance, means_of(exact.profile, mesh.normal));
    return worst(mesh, [&](const fem::StaticContact& contact, double indentation) {
      return fem::largest_contact_radius(contact.gap, events).radius / exact.contact_radius(indentation) - 1;
    });
  };
  const auto force_error = [&](const ConvergenceMesh& mesh) {
    return worst(mesh, [&](const fem::StaticContact& contact, double indentation) {
      return fem::contact_force(mesh.normal.series, contact.pressure, contact.gap).force / exact.force(indentation) - 1;
    });
  };
  return {mesh_row(exact.name, "contact radius", exact.source, meshes, radius, radius_error),
          mesh_row(exact.name, "force", exact.source, meshes, force, force_error)};
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
    const auto problem = [&](const ConvergenceMesh& mesh) -> const fem::ContactProblem& {
      return punch.normal ? mesh.normal : mesh.tangential;
    };
    const auto error = [&](const ConvergenceMesh& mesh) {
      return force_of_stuck_rings(problem(mesh), mesh.n_rings) / punch.force - 1;
    };
    const auto error_per_radius = [&](const ConvergenceMesh& mesh) {
      return (1 + error(mesh)) / fem::effective_radii(problem(mesh).compliance).radius[mesh.n_rings] - 1;
    };
    rows.push_back(mesh_row(punch.name, "force", punch.source, meshes, nominal, error));
    rows.push_back(
        mesh_row(punch.name, "force over effective radius", punch.source, meshes, effective, error_per_radius));
  }
  return rows;
}

}  // namespace fretval
