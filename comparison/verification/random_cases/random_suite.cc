#include "comparison/verification/random_cases/random_suite.h"

#include <fmt/format.h>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/support/parallel.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
namespace {

constexpr int most_attempts = 100;

std::string family_of(const Entries& entries) {
  return fmt::format("{}{}, {}", entries.count("Wear / State") > 0 ? "worn " : "", entries.at("Indenter / Shape"),
                     entries.at("Elastomer / Rheology"));
}

/// Draws until the tool takes the case. What else may be wrong with it, its row will say.
SuiteCase drawn_case(std::uint64_t seed, std::size_t number) {
  SuiteCase one{"", fmt::format("random-{}-{}", seed, number)};
  one.proof = Proof::bars;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    try {
      const auto entries = random_entries({seed, number, attempt});
      one.family = family_of(entries);
      one.text = case_text(entries);
      prepare({case_of(one)});
      return one;
    } catch (const InputError&) {
      // drawn again
    } catch (const std::exception&) {
      return one;
    }
  }
  return one;
}

}  // namespace

SuiteRun run_random_suite(const RandomSuiteOptions& options) {
  Stopwatch watch;
  SuiteRun run{"random", fmt::format("Random cases of seed {} on one coarse mesh, with their error bars but without "
                                     "any refinement.",
                                     options.seed)};
  const std::size_t first = options.only.value_or(0);
  std::vector<SuiteCase> cases(options.only ? 1 : options.n_cases);
  for_each_in_parallel(cases.size(), [&](std::size_t i) { cases[i] = drawn_case(options.seed, first + i); });
  BodyStore bodies;
  run.rows = run_cases(cases, bodies);
  run.seconds = watch.lap();
  return run;
}

}  // namespace fretval
