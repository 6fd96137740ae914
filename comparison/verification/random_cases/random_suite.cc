#include "comparison/verification/random_cases/random_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
namespace {

constexpr std::size_t batch = 1000;  // cases between two lines of the log
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
  const std::size_t first = options.only.value_or(0), end = options.only ? first + 1 : options.n_cases;
  BodyStore bodies;
  for (std::size_t begin = first; begin < end; begin += batch) {
    std::vector<SuiteCase> cases(std::min(batch, end - begin));
    for_each_in_parallel(cases.size(), [&](std::size_t i) { cases[i] = drawn_case(options.seed, begin + i); });
    auto rows = run_cases(cases, bodies);
    std::move(rows.begin(), rows.end(), std::back_inserter(run.rows));
    if (end - first > batch) log::info(fmt::format("{} of {} cases", run.rows.size(), end - first));
  }
  run.seconds = watch.lap();
  return run;
}

}  // namespace fretval
