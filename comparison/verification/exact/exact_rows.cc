#include "comparison/verification/exact/exact_rows.h"

#include <cmath>
#include <map>
#include <string>

#include "comparison/simulation/bodies/body.h"
#include "comparison/support/progress.h"
#include "fem/ring_contact/contact_events.h"
#include "fem/ring_contact/contact_force.h"
#include "fem/ring_contact/stick_zone/contact_radius.h"
#include "fem/ring_contact/stick_zone/stick_radius.h"
#include "meshes/grading.h"

namespace fretval {
namespace {

/// Rows that belong together, and about how long they take.
struct Theme {
  const char* name;
  Rows (*rows)(const Meshes&, const ExactScene&);
  double seconds;
};
constexpr Theme themes[] = {{"indentation", indentation_rows, 0.3}, {"sliding", sliding_rows, 7},
                            {"oblique loading", oblique_rows, 0.3}, {"worn edge", worn_edge_rows, 0.3},
                            {"relaxation", relaxation_rows, 1},     {"pressing", pressing_rows, 1},
                            {"periodic states", periodic_rows, 26}};
constexpr double seconds_of_meshes = 5, seconds_of_poisson_ratios = 20, seconds_of_layers = 12, seconds_of_bulk = 6;

}  // namespace

Rows exact_rows() {
  std::map<std::string, double> expected{{"meshes", seconds_of_meshes},
                                         {"Poisson's ratios", seconds_of_poisson_ratios},
                                         {"layers", seconds_of_layers},
                                         {"bulk", seconds_of_bulk}};
  for (const auto& theme : themes) expected[theme.name] = theme.seconds;
  Progress progress(expected.size(), expected);
  const auto done = [&](const std::string& part) { progress.done(part, true, part); };
  const std::vector<int> resolutions{16, 32, 64, 128};
  Rows rows;
  const auto meshes = half_space_meshes(resolutions);
  done("meshes");
  for (const auto& theme : themes) {
    append(rows, theme.rows(meshes, {}));
    done(theme.name);
  }
  append(rows, poisson_rows(resolutions, {}));
  done("Poisson's ratios");
  append(rows, layer_rows(resolutions, {}));
  done("layers");
  append(rows, bulk_rows(bulk_meshes(4), 1));
  done("bulk");
  return rows;
}

Meshes half_space_meshes(const std::vector<int>& n_rings, double poisson_ratio, double far_radius) {
  Meshes meshes;
  for (const int n : n_rings) {
    BodyDescription description{meshes::uniform_nodes(1.125, static_cast<unsigned>(n) * 9 / 8), 0.15, far_radius, 3};
    description.poisson_ratio = poisson_ratio;
    Body body = make_body(description);
    meshes.push_back({n, std::move(body.normal.contact), std::move(body.tangential->contact)});
  }
  return meshes;
}

std::vector<double> static_errors(const ConvergenceMesh& mesh, const mdr::Profile& shape,
                                  const std::vector<double>& indentations,
                                  const std::function<RadiusAndForce(double)>& known) {
  const Eigen::VectorXd profile = means_of(shape, mesh.normal);
  const auto events = fem::contact_events(mesh.normal.compliance, profile);
  const auto series = fem::series_under(mesh.normal, profile);
  double radius_error = 0, force_error = 0;
  for (const double indentation : indentations) {
    const auto contact = fem::static_contact(mesh.normal, profile, indentation);
    const auto [radius, force] = known(indentation);
    take_worst(radius_error, fem::largest_contact_radius(contact.gap, events).radius / radius - 1);
    take_worst(force_error, fem::contact_force(series, contact.pressure, contact.gap).force / force - 1);
  }
  return {radius_error, force_error};
}

double stick_radius_of(const fem::ContactProblem& tangential, const Eigen::VectorXd& limit,
                       const Eigen::VectorXd& traction, const std::vector<fem::BoxState>& states) {
  Eigen::Index n_stuck = 0;
  while (n_stuck < limit.size() && limit[n_stuck] > 0 &&
         states[static_cast<std::size_t>(n_stuck)] == fem::BoxState::interior)
    ++n_stuck;
  return fem::stick_radius(tangential.compliance, tangential.series.depths(limit - traction), n_stuck).radius;
}

double stick_radius_of_push(const ConvergenceMesh& mesh, const Eigen::VectorXd& pressure, double displacement) {
  const auto& tangential = mesh.tangential;
  const Eigen::VectorXd limit = friction_coefficient * pressure;
  std::vector<fem::BoxState> states(static_cast<std::size_t>(tangential.n_rings()), fem::BoxState::interior);
  const Eigen::VectorXd load = displacement * tangential.compliance.areas;
  const auto solution = tangential.solver.solve(load, -limit, limit, states);
  return stick_radius_of(tangential, limit, solution.x, states);
}

double position(int k, double first, double last) {
  return first + (last - first) * k / (n_positions - 1);
}

void take_worst(double& worst, double error) {
  if (!(std::abs(error) <= worst)) worst = std::isnan(worst) ? worst : std::abs(error);
}

fem::RelaxationModel fem_model(const mdr::PronyBody& body) {
  return {body.relaxed_modulus, body.branch_moduli, body.branch_times, body.viscosity};
}

void append(Rows& rows, const Rows& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

ConvergenceRow mesh_row(const ConvergenceRow& row, const Meshes& meshes,
                        const std::function<double(const ConvergenceMesh&)>& error) {
  return mesh_rows(Rows{row}, meshes, [&](const ConvergenceMesh& mesh) { return std::vector<double>{error(mesh)}; })[0];
}

ConvergenceRow time_row(ConvergenceRow row, const std::vector<int>& n_steps, const std::function<double(int)>& error) {
  row.refined = "steps";
  row.resolutions = n_steps;
  for (const int n : n_steps) row.errors.push_back(error(n));
  return row;
}

}  // namespace fretval
