#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/simulation/bodies/distributed_body.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/support/ranks.h"
#include "fem/condensation/petsc_session.h"
#include "fem/support/constants.h"

// What a body and the histories on it cost, a line of the file that tests/benchmarks/growth makes:
//   growth_benchmark body RINGS GROWTH HARMONICS              alone or under mpirun
//   growth_benchmark histories CASE RINGS STEPS RAMP_CYCLES   at the resolution for 1e-5 but for these
// Response: sum over the compliance of the last harmonic, to compare ranks. Error: of the stick radius after shakedown,
// over the contact radius.
namespace fretval {
namespace {

constexpr int kib_per_gib = 1 << 20;

/// Of the process, with all of its threads.
double processor_seconds_of_all() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// An entry of /proc/self/status, in KiB: VmHWM is the peak of the resident memory, VmRSS what it is now.
long kib_of(const std::string& entry) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (long kib = 0; word == entry + ":" && status >> kib) return kib;
  return 0;
}

/// Hands back what is free; from now on the peak is that of what follows. Returns what is left, in KiB.
long start_peak() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  return kib_of("VmRSS");
}

/// Processor time since the last call.
double lap() {
  static double last = 0;
  const double before = last;
  last = processor_seconds_of_all();
  return last - before;
}

/// By one process, or by all together; the first one has it.
std::optional<ContactBody> made_body(const BodyDescription& body, const Ranks& ranks) {
  if (!ranks.are_several()) return contact_body(make_body(body));
  const fem::Share share{static_cast<unsigned>(ranks.number()), static_cast<unsigned>(ranks.count())};
  const auto make = [&](const std::string& wanted) { return operators_made_together(wanted, share); };
  if (ranks.is_first()) return distributed_body(body, {}, {0, ranks.count(), make}, nullptr);
  make(text_of(body));
  return std::nullopt;
}

void body(int rings, double growth, bool tangential) {
  const Ranks ranks;
  const fem::PetscSession session;
  BodyDescription specification{{}, growth, 20, 3, tangential};
  for (int i = 0; i <= rings; ++i) specification.contact_nodes.push_back(static_cast<double>(i) / rings);
  lap();
  const auto made = made_body(specification, ranks);
  const auto sums = ranks.sum({std::lround(1e3 * lap()), kib_of("VmHWM")});
  if (!made) return;
  const auto& response = tangential ? *made->tangential : made->normal;
  fmt::print("body,{},{},{},{},{},,,{:.3f},,,{:.4f},{:.15f},\n", rings, growth,
             n_dofs_on(mesh_of(specification), specification.degree, tangential), tangential ? 2 : 1, ranks.count(),
             1e-3 * static_cast<double>(sums[0]), static_cast<double>(sums[1]) / kib_per_gib,
             response.compliance.matrix->sum());
}

void histories(const std::string& file, int rings, int steps, int ramp_cycles) {
  const fem::PetscSession session;
  const auto prepared = prepare(read_case_file(file)).front();
  const double exact = mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr)).stick_radius_shakedown.value_or(0);
  auto resolution = resolution_for(1e-5);
  resolution.elements_per_radius = static_cast<unsigned>(rings);
  resolution.steps_per_cycle = steps;
  resolution.n_ramp_cycles = ramp_cycles;
  const auto specification = at_resolution(prepared.fem, resolution).body;
  BodyStore bodies;
  lap();
  const auto body = find_or_make_body(specification, bodies);
  const double body_seconds = lap();
  const long before = start_peak();
  const auto answer = compute_case(prepared.fem, resolution, bodies);
  const double normal_seconds = answer.seconds.normal, friction_seconds = lap() - normal_seconds;
  const auto n = specification.contact_nodes.size() - 1;
  const double compliances_kib = 2 * 8.0 / 1024 * static_cast<double>(n * n);
  fmt::print("histories,{},{},{},2,1,{},{},{:.3f},{:.3f},{:.3f},{:.4f},,{:.2e}\n", n, resolution.growth,
             body->summary->n_dofs, answer.n_cycles, answer.n_steps, body_seconds, normal_seconds, friction_seconds,
             (static_cast<double>(kib_of("VmHWM") - before) + compliances_kib) / kib_per_gib,
             std::abs(answer.stick_radius_shakedown.value_or(0) - exact) / answer.contact_radius_max.value_or(1));
}

void run(const std::vector<std::string>& arguments) {
  if (arguments.size() == 4 && arguments[0] == "body")
    body(std::stoi(arguments[1]), std::stod(arguments[2]), arguments[3] == "2");
  else if (arguments.size() == 5 && arguments[0] == "histories")
    histories(arguments[1], std::stoi(arguments[2]), std::stoi(arguments[3]), std::stoi(arguments[4]));
  else
    std::puts(
        "part,rings,growth,dofs,harmonics,ranks,cycles,steps,body s,normal history s,friction history s,GiB,response,"
        "error");
}

}  // namespace
}  // namespace fretval

int main(int argc, char** argv) {
  fretval::run({argv + 1, argv + argc});
  return 0;
}
