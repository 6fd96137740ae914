#include "comparison/verification/random_cases/random_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/support/resident_memory.h"
#include "comparison/support/stopwatch.h"
#include "comparison/verification/random_cases/memory_watch.h"
#include "comparison/verification/suite_summary.h"

namespace fretval {
namespace {

constexpr std::size_t batch = 100;  // cases between two looks at the memory
constexpr int most_attempts = 100;

std::string family_of(const Entries& entries) {
  return fmt::format("{}{}, {}", entries.count("Wear / State") > 0 ? "worn " : "", entries.at("Indenter / Shape"),
                     entries.at("Elastomer / Rheology"));
}

/// Draws until the tool takes the case. What else may be wrong with it, its row will say.
SuiteCase drawn_case(RandomDraw& draw) {
  SuiteCase one{"", fmt::format("random-{}-{}", draw.seed, draw.number)};
  one.proof = Proof::bars;
  while (draw.attempt < most_attempts) {
    try {
      const auto entries = random_entries({draw.seed, draw.number, draw.attempt++});
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

void forget_case_files_but_of_shown(std::vector<SuiteRow>& rows) {
  const auto shown = shown_rows(rows);
  const std::set<const SuiteRow*> kept(shown.begin(), shown.end());
  for (auto& row : rows)
    if (kept.count(&row) == 0) row.asked.text = std::string();
}

SuiteCheck drawn_again_check(std::size_t n_again, std::size_t n_cases) {
  return {"drawn again", fmt::format("{} of {} cases", n_again, n_cases),
          n_again > std::max<std::size_t>(1, n_cases / 100) ? "the tool refuses too many of them" : ""};
}

}  // namespace

SuiteRun run_random_suite(const RandomSuiteOptions& options) {
  Stopwatch watch;
  SuiteRun run{"random", fmt::format("Random cases of seed {} on one coarse mesh, with their error bars but without "
                                     "any refinement.",
                                     options.seed)};
  const std::size_t first = options.only.value_or(0), end = options.only ? first + 1 : options.n_cases;
  run.rows.reserve(end - first);
  BodyStore bodies;
  std::vector<MemorySample> memory;
  std::size_t n_again = 0;
  for (std::size_t begin = first; begin < end; begin += batch) {
    std::vector<RandomDraw> draws;
    for (std::size_t k = begin; k < std::min(begin + batch, end); ++k) draws.push_back({options.seed, k});
    std::vector<SuiteCase> cases(draws.size());
    for_each_in_parallel(draws.size(), [&](std::size_t i) { cases[i] = drawn_case(draws[i]); });
    for (const auto& draw : draws) n_again += draw.attempt > 1 ? 1 : 0;
    auto rows = run_cases(cases, bodies);
    std::move(rows.begin(), rows.end(), std::back_inserter(run.rows));
    forget_case_files_but_of_shown(run.rows);
    if (const auto bytes = resident_bytes()) memory.push_back({run.rows.size(), *bytes});
    if (run.rows.size() % 1000 == 0) log::info(fmt::format("{} of {} cases", run.rows.size(), end - first));
  }
  run.checks = {memory_check(memory), drawn_again_check(n_again, run.rows.size())};
  run.seconds = watch.lap();
  return run;
}

}  // namespace fretval
