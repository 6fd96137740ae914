#include "comparison/verification/random_cases/random_suite.h"

#include <fmt/format.h>

#include <atomic>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/support/progress.h"
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

/// Tells how far it is, on a terminal from the first second on: the tool reads every case that it draws.
std::vector<SuiteCase> drawn_cases(const RandomSuiteOptions& options) {
  const std::size_t first = options.only.value_or(0);
  std::vector<SuiteCase> cases(options.only ? 1 : options.n_cases);
  constexpr std::size_t many = 1000;
  if (cases.size() >= many) log::info(fmt::format("drawing {} cases", cases.size()));
  Progress progress(1);
  std::atomic<std::size_t> n_drawn{0};
  for_each_in_parallel(cases.size(), [&](std::size_t i) {
    cases[i] = drawn_case(options.seed, first + i);
    const auto n = ++n_drawn;
    progress.under_way("cases", static_cast<double>(n) / static_cast<double>(cases.size()),
                       fmt::format("{} of {} drawn", n, cases.size()));
  });
  return cases;
}

}  // namespace

SuiteRun run_random_suite(const RandomSuiteOptions& options) {
  Stopwatch watch;
  SuiteRun run{"random", fmt::format("Random cases of seed {} on one coarse mesh, with their error bars but without "
                                     "any refinement.",
                                     options.seed)};
  const auto cases = drawn_cases(options);
  BodyStore bodies;
  run.rows = run_cases(cases, bodies);
  run.seconds = watch.lap();
  return run;
}

}  // namespace fretval
