#include "comparison/verification/exact/exact_parts.h"

#include <cmath>

#include "comparison/simulation/bodies/body.h"
#include "fem/ring_contact/box_solver.h"
#include "fem/ring_contact/stick_zone/stick_radius.h"
#include "meshes/grading.h"

namespace fretval {

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

double stick_radius_of_push(const ConvergenceMesh& mesh, const Eigen::VectorXd& pressure, double displacement) {
  const auto& tangential = mesh.tangential;
  const Eigen::VectorXd limit = friction_coefficient * pressure;
  std::vector<fem::BoxState> states(static_cast<std::size_t>(tangential.n_rings()), fem::BoxState::interior);
  const Eigen::VectorXd load = displacement * tangential.compliance.areas;
  const auto solution = tangential.solver.solve(load, -limit, limit, states);
  Eigen::Index n_stuck = 0;
  while (n_stuck < limit.size() && limit[n_stuck] > 0 &&
         states[static_cast<std::size_t>(n_stuck)] == fem::BoxState::interior)
    ++n_stuck;
  const Eigen::VectorXd reserves = tangential.series.depths(limit - solution.x);
  return fem::stick_radius(tangential.compliance, reserves, n_stuck).radius;
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
