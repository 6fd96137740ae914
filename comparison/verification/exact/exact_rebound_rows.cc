#include <algorithm>
#include <cmath>

#include "comparison/verification/exact/exact_parts.h"
#include "comparison/verification/exact/exact_time_rows.h"
#include "comparison/verification/exact/rebound.h"

namespace fretval {
namespace {

/// The sphere at the end of a step.
struct Flight {
  double position, velocity, force;
};

/// One step of the trapezoidal rule, `m dv = -(F + F_new) dt/2`, `dd = (v + v_new) dt/2`: within it the speed is
/// linear. Iterated on the force, which a step changes by dt^2/m of the stiffness of the contact.
Flight next(NormalPath& contact, const Flight& now, const Impact& impact, double begin, double dt) {
  Flight flight = now;
  for (int k = 0; k < 50; ++k) {
    const double force = flight.force;
    flight.velocity = now.velocity - (now.force + force) * dt / (2 * impact.mass);
    flight.position = now.position + (now.velocity + flight.velocity) * dt / 2;
    const auto path = [&](double t) {
      const double s = t - begin, slope = (flight.velocity - now.velocity) / dt;
      return fem::ValueAndRate{now.position + s * (now.velocity + s * slope / 2), now.velocity + s * slope};
    };
    NormalPath trial = contact;
    flight.force = trial.step(path, begin, begin + dt).value;
    if (std::abs(flight.force - force) <= 1e-13 * (1 + force)) {
      contact = std::move(trial);
      return flight;
    }
  }
  return {std::nan(""), std::nan(""), std::nan("")};
}

/// Value of the parabola through three equidistant values at its vertex.
double vertex(double before, double largest, double after) {
  const double slope = (after - before) / 2, curvature = before - 2 * largest + after;
  return curvature == 0 ? largest : largest - slope * slope / (2 * curvature);
}

struct Bounce {
  double restitution, largest_force;
};

Bounce bounce_of(const fem::ContactProblem& problem, const fem::RelaxationModel& model, const Impact& impact,
                 double dt) {
  NormalPath contact(problem, model, means_of(mdr::parabola(1), problem));
  Flight flight{0, impact.velocity, 0};
  std::vector<double> force{0};
  do {
    flight = next(contact, flight, impact, dt * static_cast<double>(force.size() - 1), dt);
    force.push_back(flight.force);
  } while (flight.velocity > 0 || flight.force > 0);
  const auto peak = static_cast<std::size_t>(std::max_element(force.begin(), force.end()) - force.begin());
  return {-flight.velocity / impact.velocity, vertex(force[peak - 1], force[peak], force[peak + 1])};
}

}  // namespace

std::vector<ConvergenceRow> rebound_rows(const std::vector<ConvergenceMesh>& meshes, const mdr::PronyBody& body,
                                         const mdr::PronyBody& exact) {
  const auto model = fem_model(body);
  ConvergenceRow restitution{"rebound",
                             "coefficient of restitution",
                             "Hunter 1960, computed to 1e-9",
                             "rings",
                             {},
                             {},
                             {1.1e-5, 2, 1e-8, std::nullopt, "h^2 and time steps of 1/8 of what a ring is wide"}};
  ConvergenceRow force = restitution;
  force.quantity = "largest force";
  force.demand.tolerance = 1.2e-4;
  for (const auto& mesh : meshes) {
    double worst_restitution = 0, worst_force = 0;
    // The largest contact radius comes out at about 1 and, mostly, one or more rings less; the contact lasts about two
    // relaxation times.
    for (const double velocity : {2.3, 2.4, 2.5, 2.6, 2.65, 2.7, 2.75, 2.8}) {
      const Impact impact{1, velocity};
      const Rebound expected = exact_rebound(exact, impact);
      const Bounce computed = bounce_of(mesh.normal, model, impact, 1.0 / (8 * mesh.n_rings));
      take_worst(worst_restitution, computed.restitution / expected.restitution - 1);
      take_worst(worst_force, computed.largest_force / expected.largest_force - 1);
    }
    for (auto* row : {&restitution, &force}) row->resolutions.push_back(mesh.n_rings);
    restitution.errors.push_back(worst_restitution);
    force.errors.push_back(worst_force);
  }
  return {restitution, force};
}

}  // namespace fretval
