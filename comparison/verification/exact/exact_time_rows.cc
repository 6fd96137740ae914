#include <algorithm>
#include <cmath>

#include "comparison/verification/exact/exact_rows.h"
#include "fem/history/contact_force.h"
#include "mdr/profiles/indentation.h"

namespace fretval {
namespace {

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

/// Largest error relative to the final force, of a parabola pressed in by d(t) = t.
double growing_contact_error(const fem::ContactProblem& problem, int n_steps, double PressingForce::*kind,
                             const LeeRadok& exact) {
  const auto path = [](double t) { return fem::ValueAndRate{t, 1}; };
  const auto forces = press(problem, means_of(mdr::parabola(1), problem), path, instants(0, 1, n_steps));
  return pressing_error(forces, kind, exact).largest_error / exact(1);
}

/// Largest error of the force after a step of the indentation, in n steps of time: over `elastic G(t)/G0`.
double relaxing_force_error(const fem::ContactProblem& problem, const Eigen::VectorXd& profile, double indentation,
                            double elastic, const mdr::PronyBody& exact, int n_steps) {
  const auto path = [indentation](double t) {
    const auto step = unit_step(t);
    return fem::ValueAndRate{indentation * step.value, indentation * step.rate};
  };
  const auto forces = press(problem, profile, path, instants(step_rise, 1, n_steps));
  double worst = 0;
  for (std::size_t k = 1; k < forces.size(); ++k) {
    const double expected = elastic * mdr::relaxation(exact, forces[k].time) / exact.relaxed_modulus;
    take_worst(worst, forces[k].value / expected - 1);
  }
  return worst;
}

}  // namespace

ConvergenceRow step_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact) {
  const auto& problem = meshes.front().normal;
  const Eigen::VectorXd punch = fem::ring_means(problem.compliance, [](double r) { return r < 1 ? 0.0 : 10.0; });
  const auto contact = fem::static_contact(problem, punch, 1);
  const double elastic = fem::contact_force(problem.series, contact.pressure, contact.gap).force;
  const ConvergenceDemand demand{1e-8, 0, 1e-8, std::nullopt, "floor: rise time of the step"};
  return time_row({"flat punch, step", "relaxing force",
                   "correspondence, Lee 1955, on the elastic force of the same rings", demand},
                  {8, 16, 32, 64}, [&](int n) { return relaxing_force_error(problem, punch, 1, elastic, exact, n); });
}

ConvergenceRow hertz_step_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact) {
  const auto parabola = mdr::parabola(1);
  const auto error = [&](const ConvergenceMesh& mesh) {
    const auto profile = means_of(parabola, mesh.normal);
    double worst = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double indentation = mdr::transform(parabola, position(k, 0.8, 1));
      const double elastic = mdr::normal_force(parabola, 1, indentation);
      take_worst(worst, relaxing_force_error(mesh.normal, profile, indentation, elastic, exact, 8));
    }
    return worst;
  };
  return mesh_row(
      {"Hertz, step", "relaxing force", "Hertz 1882, correspondence, Lee 1955", {1e-6, 3, bulk_floor, 1e-5, bulk_note}},
      meshes, error);
}

ConvergenceRow growing_contact_time_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact) {
  const auto& problem = meshes.front().normal;
  const Eigen::VectorXd profile = means_of(mdr::parabola(1), problem);
  const LeeRadok expected(
      exact, [&](double d) { return fem::static_contact(problem, profile, d).pressure.dot(problem.compliance.areas); });
  const ConvergenceDemand demand{5e-6, 2, 1e-8, std::nullopt, "", 200};
  return time_row({"Lee-Radok", "force over time", "Lee & Radok 1960, on the elastic force of the same rings", demand},
                  {50, 100, 200, 400},
                  [&](int n) { return growing_contact_error(problem, n, &PressingForce::sum, expected); });
}

ConvergenceRow growing_contact_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& exact) {
  const auto parabola = mdr::parabola(1);
  const LeeRadok expected(exact, [&](double d) { return mdr::normal_force(parabola, 1, d); });
  return mesh_row({"Lee-Radok", "force over mesh", "Lee & Radok 1960", {1e-6, 3, far_field, 1e-5, far_field_note}},
                  meshes, [&](const ConvergenceMesh& mesh) {
                    return growing_contact_error(mesh.normal, 1600, &PressingForce::value, expected);
                  });
}

}  // namespace fretval
