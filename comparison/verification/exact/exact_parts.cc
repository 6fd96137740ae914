#include "comparison/verification/exact/exact_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fem/history/contact_force.h"
#include "fem/stick_zone/stick_radius.h"
#include "fem/support/solver_error.h"

namespace fretval {

double position(int k, double first, double last) {
  return first + (last - first) * k / (n_positions - 1);
}

void take_worst(double& worst, double error) {
  if (!(std::abs(error) <= worst)) worst = std::isnan(worst) ? worst : std::abs(error);
}

Eigen::VectorXd means_of(const mdr::Profile& profile, const fem::ContactProblem& problem) {
  return fem::ring_means(problem.compliance, [&](double r) { return mdr::shape(profile, r); });
}

ConvergenceRow mesh_row(const ConvergenceRow& row, const std::vector<ConvergenceMesh>& meshes,
                        const std::function<double(const ConvergenceMesh&)>& error) {
  return mesh_rows({row}, meshes, [&](const ConvergenceMesh& mesh) { return std::vector<double>{error(mesh)}; })[0];
}

ConvergenceRow time_row(ConvergenceRow row, const std::vector<int>& n_steps, const std::function<double(int)>& error) {
  row.refined = "steps";
  row.resolutions = n_steps;
  for (const int n : n_steps) row.errors.push_back(error(n));
  return row;
}

FrictionLimit friction_limit(const ConvergenceMesh& mesh, const mdr::Profile& profile, double indentation) {
  const auto contact = fem::static_contact(mesh.normal, means_of(profile, mesh.normal), indentation);
  const auto normal = fem::contact_force(mesh.normal.series, contact.pressure, contact.gap);
  return {friction_coefficient * contact.pressure, friction_coefficient * normal.force, normal.radius};
}

ElasticSliding::ElasticSliding(const ConvergenceMesh& mesh)
    : problem_(mesh.tangential),
      touching_{mesh.normal.series.radii()},
      slip_(Eigen::VectorXd::Zero(problem_.n_rings())),
      traction_(slip_),
      limit_(slip_),
      states_(static_cast<std::size_t>(problem_.n_rings()), fem::BoxState::interior),
      zones_(problem_.n_rings()) {}

const Eigen::VectorXd& ElasticSliding::step(double displacement, const FrictionLimit& friction) {
  const auto& limit = friction.rings;
  const auto& areas = problem_.compliance.areas;
  const Eigen::VectorXd load = areas.array() * (displacement - slip_.array());
  auto solution = problem_.solver.solve(load, -limit, limit, states_);
  slip_ += solution.residual.cwiseQuotient(areas);
  traction_ = std::move(solution.x);
  limit_ = limit;
  limit_force_ = friction.force;
  touching_.move_to(friction.contact_radius);
  zones_.update(limit, states_, problem_.series.depths(traction_));
  return traction_;
}

double ElasticSliding::force() const {
  return fem::friction_force(problem_.series, zones_, touching_, problem_.series.depths(limit_), limit_force_);
}

double ElasticSliding::stick_radius() const {
  Eigen::Index n_stuck = 0;
  while (n_stuck < limit_.size() && limit_[n_stuck] > 0 &&
         states_[static_cast<std::size_t>(n_stuck)] == fem::BoxState::interior)
    ++n_stuck;
  return fem::stick_radius(problem_.compliance, problem_.series.depths(limit_ - traction_), n_stuck).radius;
}

fem::RelaxationModel fem_model(const mdr::PronyBody& body) {
  return {body.relaxed_modulus, body.branch_moduli, body.branch_times, body.viscosity};
}

mdr::PronyBody viscoelastic_body() {
  return mdr::standard_solid(1, 2, 0.4);
}

std::vector<PressingForce> press(const fem::ContactProblem& problem, const Eigen::VectorXd& profile, const Path& path,
                                 const std::vector<double>& instants) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const auto model = fem_model(viscoelastic_body());
  fem::RingState state{Eigen::VectorXd::Zero(n),
                       Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(model.times.size()))};
  std::vector<fem::BoxState> contact(static_cast<std::size_t>(n), fem::BoxState::lower);
  double largest_radius = 0;  // of the contact, so far
  std::vector<PressingForce> forces;
  for (std::size_t k = 1; k < instants.size(); ++k) {
    const double begin = instants[k - 1], end = instants[k];
    const fem::RelaxationStep step(model, end - begin);
    const double fraction = step.fraction(), balance = begin + fraction * (end - begin);
    const Eigen::VectorXd gap = (state.displacement + profile).array() - path(begin).value;
    const Eigen::VectorXd held = step.response_without_slip(state, fem::indenter_move(path, begin, balance));
    const Eigen::VectorXd load = areas.cwiseProduct(held - step.instantaneous() * gap);
    const auto solution = problem.solver.solve(
        load, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity()), contact);
    if (solution.x[n - 1] > 0) throw fem::SolverError("the contact reaches the end of the contact line");
    const Eigen::VectorXd new_gap = -solution.residual.cwiseQuotient(areas) / step.instantaneous();
    step.advance(state, fem::indenter_move(path, begin, end), gap - new_gap);
    const auto force =
        fem::contact_force(problem.series, solution.x, fraction * new_gap + (1 - fraction) * gap, {largest_radius});
    largest_radius = std::max(largest_radius, force.radius);
    forces.push_back({balance, force.force, solution.x.dot(areas)});
  }
  return forces;
}

PressingError pressing_error(const std::vector<PressingForce>& forces, double PressingForce::*kind,
                             const std::function<double(double)>& exact) {
  PressingError error{0, 0};
  for (const auto& force : forces) {
    if (force.time <= 0.3 && !std::isnan(force.*kind)) continue;
    const double expected = exact(force.time);
    error.largest_exact = std::max(error.largest_exact, expected);
    take_worst(error.largest_error, force.*kind - expected);
  }
  return error;
}

std::vector<double> instants(double first, double end, int n) {
  std::vector<double> t{0};
  if (first > 0) t.push_back(first);
  for (int k = 1; k <= n; ++k) t.push_back(first + (end - first) * k / n);
  return t;
}

fem::ValueAndRate unit_step(double t) {
  const double x = std::min(t / step_rise, 1.0);
  return {x * x * (3 - 2 * x), 6 * x * (1 - x) / step_rise};
}

}  // namespace fretval
