#include "comparison/verification/exact/exact_time_rows.h"

#include <algorithm>
#include <cmath>

#include "comparison/verification/exact/exact_parts.h"
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

/// Largest error over 0.3 < t < 1 relative to the final force, of a parabola pressed in by d(t) = t.
double growing_contact_error(const fem::ContactProblem& problem, const mdr::PronyBody& body, int n_steps,
                             double NormalPath::Force::*kind, const LeeRadok& exact) {
  const auto path = [](double t) { return fem::ValueAndRate{t, 1}; };
  const auto profile = means_of(mdr::parabola(1), problem);
  double worst = 0;
  for (const auto& force : press(problem, fem_model(body), profile, path, instants(0, 1, n_steps))) {
    const double error = force.*kind / exact(1) - exact(force.time) / exact(1);
    if (force.time > 0.3 || std::isnan(error)) take_worst(worst, error);
  }
  return worst;
}

/// Largest error of the force after a step of the indentation, in n steps of time: over `elastic G(t)/G0`.
double relaxing_force_error(const fem::ContactProblem& problem, const Eigen::VectorXd& profile, double indentation,
                            double elastic, const mdr::PronyBody& body, const mdr::PronyBody& exact, int n_steps) {
  const auto path = [indentation](double t) {
    const auto step = unit_step(t);
    return fem::ValueAndRate{indentation * step.value, indentation * step.rate};
  };
  const auto forces = press(problem, fem_model(body), profile, path, instants(step_rise, 1, n_steps));
  double worst = 0;
  for (std::size_t k = 1; k < forces.size(); ++k) {
    const double expected = elastic * mdr::relaxation(exact, forces[k].time) / exact.relaxed_modulus;
    take_worst(worst, forces[k].value / expected - 1);
  }
  return worst;
}

}  // namespace

ConvergenceRow step_row(const ConvergenceMesh& mesh, const mdr::PronyBody& body, const mdr::PronyBody& exact) {
  const Eigen::VectorXd punch = fem::ring_means(mesh.normal.compliance, [](double r) { return r < 1 ? 0.0 : 10.0; });
  const auto contact = fem::static_contact(mesh.normal, punch, 1);
  const double elastic = fem::contact_force(mesh.normal.series, contact.pressure, contact.gap).force;
  return time_row("flat punch, step", "relaxing force",
                  "correspondence, Lee 1955, on the elastic force of the same rings", {8, 16, 32, 64},
                  {1e-8, 0, 1e-8, std::nullopt, "floor: rise time of the step"},
                  [&](int n) { return relaxing_force_error(mesh.normal, punch, 1, elastic, body, exact, n); });
}

ConvergenceRow hertz_step_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                              const mdr::PronyBody& exact) {
  const auto parabola = mdr::parabola(1);
  const auto error = [&](const ConvergenceMesh& mesh) {
    const auto profile = means_of(parabola, mesh.normal);
    double worst = 0;
    for (int k = 0; k < n_positions; ++k) {
      const double indentation = mdr::transform(parabola, position(k, 0.8, 1));
      const double elastic = mdr::normal_force(parabola, 1, indentation);
      take_worst(worst, relaxing_force_error(mesh.normal, profile, indentation, elastic, body, exact, 8));
    }
    return worst;
  };
  return mesh_row("Hertz, step", "relaxing force", "Hertz 1882, correspondence, Lee 1955", meshes,
                  {1e-6, 3, bulk_floor, 1e-5, bulk_note}, error);
}

ConvergenceRow growing_contact_time_row(const ConvergenceMesh& mesh, const mdr::PronyBody& body,
                                        const mdr::PronyBody& exact) {
  const Eigen::VectorXd profile = means_of(mdr::parabola(1), mesh.normal);
  const LeeRadok expected(exact, [&](double d) {
    return fem::static_contact(mesh.normal, profile, d).pressure.dot(mesh.normal.compliance.areas);
  });
  const auto error = [&](int n) {
    return growing_contact_error(mesh.normal, body, n, &NormalPath::Force::sum, expected);
  };
  return time_row("Lee-Radok", "force over time", "Lee & Radok 1960, on the elastic force of the same rings",
                  {50, 100, 200, 400}, {5e-6, 2, 1e-8, std::nullopt, "", 200}, error);
}

ConvergenceRow growing_contact_mesh_row(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                                        const mdr::PronyBody& exact) {
  const auto parabola = mdr::parabola(1);
  const LeeRadok expected(exact, [&](double d) { return mdr::normal_force(parabola, 1, d); });
  const auto error = [&](const ConvergenceMesh& mesh) {
    return growing_contact_error(mesh.normal, body, 1600, &NormalPath::Force::value, expected);
  };
  return mesh_row("Lee-Radok", "force over mesh", "Lee & Radok 1960", meshes,
                  {1e-6, 3, far_field, 1e-5, far_field_note}, error);
}

}  // namespace fretval
