#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "comparison/simulation/bodies/kept_body.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/support/folders.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

// The stages of cases/examples/fretting.prm without a proof, over the rings per contact radius. Wall time: both
// harmonics are made side by side.

PreparedCase example(unsigned rings) {
  auto prepared = prepare(read_case_file(data_folder() / "cases" / "examples" / "fretting.prm")).front();
  auto resolution = prepared.fem.resolution;
  resolution.elements_per_radius = rings;
  prepared.fem = at_resolution(prepared.fem, resolution);
  return prepared;
}

BodyDescription specification(const benchmark::State& state) {
  return example(static_cast<unsigned>(state.range(0))).fem.body;
}

void mesh(benchmark::State& state) {
  const auto body = specification(state);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(mesh_of(body));
}

void assembly(benchmark::State& state) {
  const auto body = specification(state);
  const auto disc = mesh_of(body);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(assemble_operators(disc, "mesh", body));
}

void factor_and_schur(benchmark::State& state) {
  const auto body = specification(state);
  const auto disc = mesh_of(body);
  for ([[maybe_unused]] auto _ : state) {
    state.PauseTiming();
    auto operators = assemble_operators(disc, "mesh", body);
    state.ResumeTiming();
    benchmark::DoNotOptimize(condense(std::move(operators)));
  }
}

void from_store(benchmark::State& state) {
  const auto folder = fs::temp_directory_path() / ("fretval-benchmark-" + std::to_string(getpid()));
  const auto body = specification(state);
  OperatorStore operators(folder);
  keep_body(body, make_body(body), operators);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(kept_body(body, {}, operators));
  fs::remove_all(folder);
}

/// Steps of both histories per second: items_per_second.
void histories(benchmark::State& state) {
  const auto prepared = example(static_cast<unsigned>(state.range(0)));
  BodyStore bodies;
  const auto body = find_or_make_body(prepared.fem.body, bodies);
  long n_steps = 0;
  for ([[maybe_unused]] auto _ : state) {
    BodyStore own;  // without a history that is there already
    own.find_or_make(prepared.fem.body, [&] { return *body; });
    n_steps += compute_case(prepared.fem, prepared.fem.resolution, own).n_steps;
  }
  state.SetItemsProcessed(n_steps);
}

/// From the mesh to the stick radii, with nothing kept: six cycles of 200 steps of an elastic body. Over
/// factor_and_schur it tells how far a case is from the floor of its method.
void whole_case(benchmark::State& state) {
  auto prepared = example(static_cast<unsigned>(state.range(0)));
  prepared.fem.relaxation.moduli.clear();
  prepared.fem.relaxation.times.clear();
  auto resolution = prepared.fem.resolution;
  resolution.steps_per_cycle = 200;
  resolution.n_ramp_cycles = 2;
  double n_steps = 0;
  for ([[maybe_unused]] auto _ : state) {
    BodyStore bodies;
    n_steps = static_cast<double>(compute_case(prepared.fem, resolution, bodies).n_steps);
  }
  state.counters["steps"] = n_steps;
}

void set_up(benchmark::internal::Benchmark* stage) {
  stage->Arg(16)->Arg(32)->Arg(64)->Arg(128)->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(mesh)->Apply(set_up);
BENCHMARK(assembly)->Apply(set_up);
BENCHMARK(factor_and_schur)->Apply(set_up);
BENCHMARK(from_store)->Apply(set_up);
BENCHMARK(histories)->Apply(set_up);
BENCHMARK(whole_case)->Apply(set_up);

}  // namespace
}  // namespace fretval
