#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include "mdr/springs/spring_step.h"
#include "mdr/stick/limiting_profile.h"
#include "mdr/stick/stick_radius.h"
#include "mdr/support/constants.h"

namespace fretval::mdr {
namespace {

const Motion motion{1e-4, 2.5e-5, 2e-5, 1, 1, 0.7};

void stick_radius_pair(benchmark::State& state, const Profile& profile, const Rheology& body) {
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(stick_radii(profile, body, 0.5, motion));
}
BENCHMARK_CAPTURE(stick_radius_pair, parabola_elastic, parabola(1e-2), elastic(1e6));
BENCHMARK_CAPTURE(stick_radius_pair, parabola_standard_solid, parabola(1e-2), standard_solid(1e6, 2e6, 0.1));
BENCHMARK_CAPTURE(stick_radius_pair, parabola_ten_branches, parabola(1e-2),
                  prony(1e6, std::vector<double>(10, 1e5), std::vector<double>(10, 0.1)));
BENCHMARK_CAPTURE(stick_radius_pair, power_law, power_law(3, 1.7), standard_solid(1e6, 2e6, 0.1));

void limiting_profile_of_1000_points(benchmark::State& state, const Profile& profile) {
  const double a0 = inverse_transform(profile, maximum_indentation(motion));
  std::vector<double> f(1000);
  for ([[maybe_unused]] auto _ : state) {
    const LimitingProfile worn = limiting_profile(profile, 0.6 * a0, maximum_indentation(motion));
    for (std::size_t k = 0; k < f.size(); ++k) f[k] = shape(worn, 2 * a0 * static_cast<double>(k) / 1000);
    benchmark::DoNotOptimize(f.data());
  }
}
BENCHMARK_CAPTURE(limiting_profile_of_1000_points, parabola, parabola(1e-2))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(limiting_profile_of_1000_points, cone, cone(0.1))->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(limiting_profile_of_1000_points, power_law, power_law(3, 1.7))->Unit(benchmark::kMicrosecond);

// Springs moved by one step, per second: items_per_second.
void spring_steps(benchmark::State& state, const PronyBody& body) {
  const Profile profile = parabola(1e-2);
  const SpringBed bed = spring_bed(profile, inverse_transform(profile, 1.3e-4), 1000);
  const SpringStep step(body, 0.5, 1.0 / 360);
  SpringState springs = relaxed_state(bed, body, motion.indentation);
  int k = 0;
  for ([[maybe_unused]] auto _ : state) {
    const double angle = 2 * pi * (++k % 360) / 360;
    step.advance(springs, bed, {1e-4 + 2.5e-5 * std::cos(angle), 0, 2e-5 * std::cos(angle + 0.7), 0});
    benchmark::DoNotOptimize(springs.tangential_load.data());
  }
  state.SetItemsProcessed(state.iterations() * bed.depth.size());
}
BENCHMARK_CAPTURE(spring_steps, elastic, elastic(1e6));
BENCHMARK_CAPTURE(spring_steps, one_branch, standard_solid(1e6, 2e6, 0.1));
BENCHMARK_CAPTURE(spring_steps, three_branches, prony(1e6, {1e6, 5e5, 2e5}, {0.01, 0.1, 1}));
BENCHMARK_CAPTURE(spring_steps, ten_branches, prony(1e6, std::vector<double>(10, 1e5), std::vector<double>(10, 0.1)));
BENCHMARK_CAPTURE(spring_steps, kelvin_voigt, kelvin_voigt(1e6, 1e5));

// A measured profile: rows of a truncated sphere with noise.
void convex_fit_of_a_table(benchmark::State& state) {
  constexpr double noise = 1e-6;
  const auto n = static_cast<int>(state.range(0));
  const Profile sphere = truncated_sphere(3, 0.4);
  std::mt19937 random(9);
  std::normal_distribution<double> scatter(0, noise);
  std::vector<double> r(static_cast<std::size_t>(n)), f(r.size());
  for (std::size_t k = 0; k < r.size(); ++k) {
    r[k] = static_cast<double>(k) / (n - 1);
    f[k] = shape(sphere, r[k]) + scatter(random);
  }
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(tabulated(r, f, noise));
}
BENCHMARK(convex_fit_of_a_table)->Arg(500)->Arg(5000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace fretval::mdr
