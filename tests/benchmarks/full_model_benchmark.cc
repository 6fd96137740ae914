#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "comparison/simulation/bodies/body.h"
#include "comparison/support/stopwatch.h"
#include "fem/condensation/petsc_session.h"
#include "fem/full_model/full_history.h"
#include "fem/history/friction_history.h"
#include "fem/ring_contact/static_contact.h"
#include "fem/support/constants.h"

// What condensation saves: full_model_benchmark RINGS [STEPS [CYCLES]]. One history of a parabola on a standard solid,
// from the mesh to the tractions of the last cycle, condensed and with every degree of freedom in every iteration of
// every step: with a sparse factor that serves as long as the contact stays, and with one for each iteration.
namespace fretval {
namespace {

constexpr double mu = 0.5;

struct History {
  fem::RelaxationModel relaxation{1, {1}, {0.6}, 0};
  fem::Motion motion = fem::one_frequency(1 / 1.2, 0.2 / 1.2, 0.15 / 1.2, fem::pi / 3);
  int n_steps, n_cycles;

  History(int steps, int cycles) : n_steps(steps), n_cycles(cycles) { motion.n_ramp_cycles = cycles - 1; }
};

BodyDescription body_of_rings(int rings) {
  BodyDescription body{{}, 0.5, 12, 3, true};
  for (int i = 0; i <= rings + rings / 8; ++i) body.contact_nodes.push_back(static_cast<double>(i) / rings);
  return body;
}

Eigen::VectorXd parabola(const Body& body) {
  return fem::ring_means(body.normal.contact.compliance, [](double r) { return r * r; });
}

/// Tractions of the last cycle. As in the full model, a ring is held from the start of the step in which it touches.
Eigen::MatrixXd condensed(const Body& body, const History& history) {
  fem::NormalContact normal(body.normal.contact, history.relaxation, parabola(body), history.motion, history.n_steps);
  fem::WatchedFriction friction(body.tangential->contact, history.relaxation, mu, history.motion, history.n_steps);
  for (int k = 0; k < history.n_cycles * history.n_steps; ++k) {
    normal.step();
    friction.step(normal.pressure);
  }
  return friction.period.traction();
}

Eigen::MatrixXd full(const Body& body, const History& history, fem::SparseFactors factors, int& n_factorisations) {
  const auto& [relaxation, motion, n_steps, n_cycles] = history;
  const auto normal = fem::full_normal_history(body.normal.space, body.normal.contact.series, relaxation,
                                               parabola(body), motion, n_steps, n_cycles, factors);
  const auto friction = fem::full_friction_history(body.tangential->space, relaxation, mu, motion, normal.pressure,
                                                   n_steps, n_cycles, factors);
  n_factorisations = normal.count.n_factorisations + friction.count.n_factorisations;
  return friction.traction.rightCols(n_steps);
}

void run(int rings, const History& history) {
  const fem::PetscSession session;
  Stopwatch watch;
  const auto body = make_body(body_of_rings(rings));
  const auto traction = condensed(body, history);
  const double seconds = watch.lap();
  fmt::print("{} rings, {} dofs, {} steps\n", rings, body.n_dofs(), history.n_cycles * history.n_steps);
  fmt::print("{:<42} {:>9.3f} s\n", "condensed, with mesh and condensation", seconds);
  for (const auto factors : {fem::SparseFactors::kept, fem::SparseFactors::made_anew}) {
    int n_factorisations = 0;
    const auto other = full(body, history, factors, n_factorisations);
    const double all = watch.lap();
    fmt::print("{:<42} {:>9.3f} s: {:.0f} times, {} factorisations, differs by {:.1e}\n",
               factors == fem::SparseFactors::kept ? "all dofs, factor kept while contact stays"
                                                   : "all dofs, a factor for each iteration",
               all, all / seconds, n_factorisations,
               (other - traction).lpNorm<Eigen::Infinity>() / traction.lpNorm<Eigen::Infinity>());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace fretval

int main(int argc, char** argv) {
  const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  fretval::run(argument(1, 16), {argument(2, 72), argument(3, 10)});
  return 0;
}
