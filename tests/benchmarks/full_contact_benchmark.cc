#include <benchmark/benchmark.h>

#include "fem/full_contact/surface_history.h"
#include "fem/ring_contact/static_contact.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"

// Histories of the contact on rings and angles, five cycles of 60 steps: with friction alone along x and in a circle,
// and with pressure and friction coupled along x. Arguments: rings within the contact radius, angles.
namespace fretval {
namespace {

constexpr int n_steps = 60, n_cycles = 5;
constexpr double mu = 0.5;

struct Scene {
  fem::SurfaceCompliance surface;
  fem::RingProblems rings;
  Eigen::VectorXd profile;

  Scene(unsigned n_rings, unsigned n_angles, double poisson_ratio)
      : surface([&] {
          auto grid = fem::quarter_disc_grid(1.125, n_rings * 9 / 8, 12, 0.5);
          grid.elasticity.poisson_ratio = poisson_ratio;
          return fem::surface_compliance(grid, n_angles / 2 + 1);
        }()),
        rings(fem::ring_problems(surface)),
        profile(fem::ring_means(rings.normal.compliance, [](double r) { return r * r; })) {}
};

fem::Motion motion_of(bool circle) {
  auto motion = fem::one_frequency(1 / 1.2, circle ? 0 : 0.2 / 1.2, 0.15, fem::pi / 3);
  if (circle) motion.tangential.push_back({0.15, 1, fem::pi / 3 + fem::pi / 2, true});
  motion.n_ramp_cycles = 1;
  return motion;
}

void friction(benchmark::State& state, bool circle) {
  const auto n_angles = static_cast<unsigned>(state.range(1));
  const Scene scene(static_cast<unsigned>(state.range(0)), n_angles, 0.5);
  const auto motion = motion_of(circle);
  const auto lateral = fem::lateral_motion(motion);
  const auto grid = fem::angular_grid(n_angles, circle ? fem::Mirrors::none : fem::Mirrors::x_and_y);
  const fem::SurfaceOperator op(scene.surface, grid, fem::SurfaceField::tangential);
  for (auto _ : state) {
    const auto history = fem::vector_friction_history(
        fem::VectorFriction(op, {}, mu, lateral, n_steps),
        [&](long step) {
          const double t = 2 * fem::pi * static_cast<double>(step + 1) / n_steps;
          return fem::static_contact(scene.rings.normal, scene.profile, fem::normal_motion(motion, t).value).pressure;
        },
        scene.rings, fem::exactly(n_cycles));
    benchmark::DoNotOptimize(history.dissipated.back());
  }
}

void coupled(benchmark::State& state) {
  const auto n_angles = static_cast<unsigned>(state.range(1));
  const Scene scene(static_cast<unsigned>(state.range(0)), n_angles, 0.3);
  const auto motion = motion_of(false);
  const auto way = fem::indenter_motion(motion);
  const auto operators = fem::coupled_operators(scene.surface, fem::angular_grid(n_angles, fem::Mirrors::x));
  for (auto _ : state) {
    const auto history = fem::coupled_contact_history(
        fem::CoupledContact(operators, {}, mu, scene.profile.replicate(1, operators.normal.grid().n_kept()), way,
                            n_steps),
        scene.rings, fem::exactly(n_cycles));
    benchmark::DoNotOptimize(history.dissipated.back());
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Unit(benchmark::kMillisecond)->ArgNames({"rings", "angles"});
  for (const int rings : {24, 48, 96, 192}) benchmark->Args({rings, 16});
  for (const int angles : {32, 64}) benchmark->Args({48, angles});
  benchmark->Args({96, 64});
}

BENCHMARK_CAPTURE(friction, along_x, false)->Apply(sizes);
BENCHMARK_CAPTURE(friction, circle, true)->Apply(sizes);
BENCHMARK(coupled)->Apply(sizes);

}  // namespace
}  // namespace fretval
