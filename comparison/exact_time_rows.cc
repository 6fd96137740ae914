#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/exact_rows.h"
#include "fem/relaxation.h"
#include "mdr/indentation.h"

namespace fretval {
namespace {

using Path = std::function<fem::ValueAndRate(double)>;

struct Loading {
  std::vector<double> time, force;  // at the balance times
};

fem::RelaxationModel fem_model(const mdr::PronyBody& body) {
  return {body.relaxed_modulus, body.branch_moduli, body.branch_times, body.viscosity};
}

/// Presses an indenter in along a path, from rest, in the intervals between the instants.
Loading press(const fem::ContactProblem& problem, const fem::RelaxationModel& model, const Eigen::VectorXd& profile,
              const Path& path, const std::vector<double>& instants) {
  const Eigen::Index n = problem.n_rings();
  const auto& areas = problem.compliance.areas;
  const Eigen::VectorXd infinite = Eigen::VectorXd::Constant(n, std::numeric_limits<double>::infinity());
  fem::RingState state{Eigen::VectorXd::Zero(n),
                       Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(model.times.size()))};
  std::vector<fem::BoxState> contact(static_cast<std::size_t>(n), fem::BoxState::lower);
  Loading loading;
  for (std::size_t k = 1; k < instants.size(); ++k) {
    const double begin = instants[k - 1], end = instants[k];
    const fem::RelaxationStep step(model, end - begin);
    const double balance = begin + step.fraction() * (end - begin);
    const Eigen::VectorXd gap = (state.displacement + profile).array() - path(begin).value;
    const Eigen::VectorXd held = step.response_without_slip(state, fem::indenter_move(path, begin, balance));
    const Eigen::VectorXd load = areas.cwiseProduct(held - step.instantaneous() * gap);
    const auto solution = problem.solver.solve(load, Eigen::VectorXd::Zero(n), infinite, contact);
    const Eigen::VectorXd new_gap = -solution.residual.cwiseQuotient(areas) / step.instantaneous();
    step.advance(state, fem::indenter_move(path, begin, end), gap - new_gap);
    loading.time.push_back(balance);
    loading.force.push_back(solution.x.dot(areas));
  }
  return loading;
}

/// 0, first, and n equal steps up to the end.
std::vector<double> instants(double first, double end, int n) {
  std::vector<double> t{0};
  if (first > 0) t.push_back(first);
  for (int k = 1; k <= n; ++k) t.push_back(first + (end - first) * k / n);
  return t;
}

Eigen::VectorXd parabola_means(const fem::ContactProblem& problem) {
  return fem::ring_means(problem.compliance, [](double r) { return r * r / 2; });
}

/// Lee and Radok's force `int_0^t G(t - t') dF(t')` on a fine grid of [0, 1], F(t) the elastic force at the indentation
/// t. F is linear between the points of the grid, which leaves 1e-8.
class LeeRadok {
 public:
  LeeRadok(const mdr::PronyBody& body, const std::function<double(double)>& elastic_force) {
    const double dt = 1.0 / n_points;
    std::vector<double> memory(body.branch_moduli.size(), 0);
    double before = elastic_force(0);
    force_.push_back(before);
    for (int k = 1; k <= n_points; ++k) {
      const double now = elastic_force(k * dt);
      double total = body.relaxed_modulus * now;
      for (std::size_t i = 0; i < memory.size(); ++i) {
        const double tau = body.branch_times[i], decay = std::exp(-dt / tau);
        memory[i] = decay * memory[i] + body.branch_moduli[i] * tau / dt * (1 - decay) * (now - before);
        total += memory[i];
      }
      force_.push_back(total);
      before = now;
    }
  }

  [[nodiscard]] double operator()(double t) const {
    const double x = t * n_points;
    const auto k = std::min(static_cast<std::size_t>(x), force_.size() - 2);
    return force_[k] + (x - static_cast<double>(k)) * (force_[k + 1] - force_[k]);
  }

 private:
  static constexpr int n_points = 6400;
  std::vector<double> force_;
};

/// Largest error over 0.3 < t < 1 relative to the final force, of a parabola pressed in by d(t) = t.
double growing_contact_error(const fem::ContactProblem& problem, const mdr::PronyBody& body, int n_steps,
                             const LeeRadok& exact) {
  const auto loading = press(
      problem, fem_model(body), parabola_means(problem),
      [](double t) {
        return fem::ValueAndRate{t, 1};
      },
      instants(0, 1, n_steps));
  double worst = 0;
  for (std::size_t k = 0; k < loading.time.size(); ++k) {
    const double error = std::abs(loading.force[k] / exact(1) - exact(loading.time[k]) / exact(1));
    if (std::isnan(error)) return error;
    if (loading.time[k] > 0.3) worst = std::max(worst, error);
  }
  return worst;
}

}  // namespace

LadderRow step_row(const LadderMesh& mesh, const mdr::PronyBody& body, const mdr::PronyBody& exact) {
  // A rise this short is a step to a relative 1e-9/tau. Its rate is quadratic, as the scheme takes it.
  const double rise = 1e-9;
  const auto path = [rise](double t) {
    const double x = std::min(t / rise, 1.0);
    return fem::ValueAndRate{x * x * (3 - 2 * x), 6 * x * (1 - x) / rise};
  };
  const auto& compliance = mesh.normal.compliance;
  const Eigen::VectorXd punch = fem::ring_means(compliance, [](double r) { return r < 1 ? 0.0 : 10.0; });
  const double elastic = fem::normal_contact(mesh.normal, punch, 1).pressure.dot(compliance.areas);
  LadderRow row{"flat punch, step",
                "relaxing force",
                "correspondence, Lee 1955, on the elastic force of the same rings",
                "steps",
                {8, 16, 32, 64},
                {},
                {1e-8, 0, 1e-8, std::nullopt, "floor: rise time of the step"}};
  for (const int n : row.resolutions) {
    const auto loading = press(mesh.normal, fem_model(body), punch, path, instants(rise, 1, n));
    double worst = 0;
    for (std::size_t k = 1; k < loading.time.size(); ++k) {
      const double force = elastic * mdr::relaxation(exact, loading.time[k]) / exact.relaxed_modulus;
      const double error = std::abs(loading.force[k] / force - 1);
      worst = std::isnan(error) ? error : std::max(worst, error);
    }
    row.errors.push_back(worst);
  }
  return row;
}

LadderRow growing_contact_time_row(const LadderMesh& mesh, const mdr::PronyBody& body, const mdr::PronyBody& exact) {
  const Eigen::VectorXd profile = parabola_means(mesh.normal);
  const LeeRadok expected(exact, [&](double d) {
    return fem::normal_contact(mesh.normal, profile, d).pressure.dot(mesh.normal.compliance.areas);
  });
  LadderRow row{"Lee-Radok",
                "force over time",
                "Lee & Radok 1960, on the elastic force of the same rings",
                "steps",
                {50, 100, 200, 400},
                {},
                {5e-6, 2, 1e-8, std::nullopt, "", 200}};
  for (const int n : row.resolutions) row.errors.push_back(growing_contact_error(mesh.normal, body, n, expected));
  return row;
}

LadderRow growing_contact_mesh_row(const std::vector<LadderMesh>& meshes, const mdr::PronyBody& body,
                                   const mdr::PronyBody& exact) {
  const auto parabola = mdr::parabola(1);
  const LeeRadok expected(exact, [&](double d) { return mdr::normal_force(parabola, 1, d); });
  LadderRow row{"Lee-Radok",
                "force over mesh",
                "Lee & Radok 1960",
                "rings",
                {},
                {},
                {1.5e-4, 2, 1e-8, 1e-5, "constant pressure on rings: h^2"}};
  for (const auto& mesh : meshes) {
    row.resolutions.push_back(mesh.n_rings);
    row.errors.push_back(growing_contact_error(mesh.normal, body, 1600, expected));
  }
  return row;
}

}  // namespace fretval
