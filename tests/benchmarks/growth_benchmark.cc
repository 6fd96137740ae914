#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "comparison/simulation/bodies/distributed_body.h"
#include "comparison/support/ranks.h"
#include "comparison/support/stopwatch.h"
#include "fem/condensation/petsc_session.h"

// What one body costs: growth_benchmark RINGS [GROWTH [DEGREE]], alone or under mpirun; a line of the table that
// tests/benchmarks/growth makes. Response: the sum over the tangential compliance, to compare.
namespace fretval {
namespace {

struct Cost {
  double wall;
  long processor_milliseconds, peak_kilobytes;
};

Cost cost_of_process(double wall) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto milliseconds = [](const timeval& time) { return time.tv_sec * 1000 + time.tv_usec / 1000; };
  return {wall, milliseconds(usage.ru_utime) + milliseconds(usage.ru_stime), usage.ru_maxrss};
}

BodySpecification body_of_rings(int rings, double growth, unsigned degree) {
  BodySpecification body{{}, growth, 20, degree, true};
  for (int i = 0; i <= rings; ++i) body.contact_nodes.push_back(static_cast<double>(i) / rings);
  return body;
}

/// By one process, or by all together; the first one has it.
std::optional<ContactBody> made_body(const BodySpecification& body, const Ranks& ranks) {
  if (!ranks.are_several()) return contact_body(make_body(body));
  const fem::Share share{static_cast<unsigned>(ranks.number()), static_cast<unsigned>(ranks.count())};
  const auto make = [&](const std::string& wanted) { return operators_made_together(wanted, share); };
  if (ranks.is_first()) return distributed_body(body, {0, ranks.count(), make}, nullptr);
  make(text_of(body));
  return std::nullopt;
}

void print(const BodySpecification& body, const Ranks& ranks, std::size_t n_dofs, const Cost& cost, double response) {
  const auto sums = ranks.sum({cost.processor_milliseconds, cost.peak_kilobytes});
  if (!ranks.is_first()) return;
  fmt::print("{:>5} {:>6} {:>6} {:>9} {:>5} {:>9.2f} {:>9.2f} {:>9.3f} {:.15f}\n", body.contact_nodes.size() - 1,
             body.growth, body.degree, n_dofs, ranks.count(), cost.wall, static_cast<double>(sums[0]) / 1000,
             static_cast<double>(sums[1]) / (1 << 20), response);
}

void run(int rings, double growth, unsigned degree) {
  const Ranks ranks;
  const fem::PetscSession session;
  const auto body = body_of_rings(rings, growth, degree);
  Stopwatch watch;
  const auto made = made_body(body, ranks);
  const auto cost = cost_of_process(watch.lap());
  print(body, ranks, n_dofs_on(mesh_of(body), degree, true), cost,
        made ? made->tangential->compliance.matrix->sum() : 0);
}

}  // namespace
}  // namespace fretval

int main(int argc, char** argv) {
  if (argc < 2) {
    std::puts("rings growth degree      dofs ranks    wall s     cpu s  peak GiB response");
    return 0;
  }
  fretval::run(std::atoi(argv[1]), argc > 2 ? std::atof(argv[2]) : 0.3,
               argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 3);
  return 0;
}
