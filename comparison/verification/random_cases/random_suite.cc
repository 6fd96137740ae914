#include "comparison/verification/random_cases/random_suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/study_driver.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/results/batch.h"
#include "comparison/support/parallel.h"
#include "comparison/support/resident_memory.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
namespace {

constexpr double roundoff = 1e-12;
constexpr int most_attempts = 100;

/// A case on its way.
struct Job {
  SoakRecord* record;
  std::optional<PreparedCase> prepared;  ///< empty: failed
  Measures exact = {};
};

/// Draws until the tool takes the case.
PreparedCase draw(SoakRecord& record) {
  while (true) {
    try {
      const auto name = fmt::format("soak-{}-{}", record.draw.seed, record.draw.number);
      return prepare({case_of(soak_entries(record.draw), name, name)}).front();
    } catch (const InputError& error) {
      record.refusal = error.what();
      if (++record.draw.attempt == most_attempts) throw;
    }
  }
}

/// Everything about a case but its finite elements.
Job begin(SoakRecord& record) {
  Job job{&record, std::nullopt};
  try {
    auto prepared = draw(record);
    job.exact = measures_of(mdr_answer(prepared.mdr, mdr_normal_response(prepared.mdr)), prepared.fem.units,
                            prepared.fem.worn_edge.has_value());
    job.prepared = std::move(prepared);
  } catch (const std::exception& error) {
    record.failure = error.what();
  }
  return job;
}

SoakError error_of(const std::string& quantity, double exact, double fe, const ErrorBudget& budget) {
  SoakError error{exact, fe, std::numeric_limits<double>::infinity(), ErrorSource::edge};
  const auto found = budget.find(quantity);
  if (found == budget.end()) return error;
  error.bar = found->second.total();
  if (const auto* largest = found->second.largest()) error.source = largest->source;
  return error;
}

void finish(const Job& job, const StudyResult& study, SoakRecord& record) {
  record.failure = study.answer.failure;
  if (!record.failure.empty()) return;
  record.seconds = study.answer.fe.seconds + study.answer.normal->seconds;
  const auto measures = measures_of(study.answer.fe, job.prepared->fem.units);
  for (std::size_t q = 0; q < soak_quantities.size(); ++q) {
    const auto found = measures.find(soak_quantities[q]);
    if (found != measures.end())
      record.errors[q] = error_of(found->first, job.exact.at(found->first), found->second, study.budget);
  }
}

/// Finite elements of some jobs. One whose exception is not a failure of the numerics is found by halves.
long run_jobs(const std::vector<const Job*>& jobs, BodyStore& bodies) {
  if (jobs.empty()) return 0;
  try {
    std::vector<CaseStudy> studies;
    studies.reserve(jobs.size());
    for (const auto* job : jobs) studies.emplace_back(*job->prepared, StudyDepth::budget);
    run_studies(studies, bodies);
    long n_histories = 0;
    for (std::size_t j = 0; j < jobs.size(); ++j) {
      const auto result = studies[j].result();
      n_histories += result.n_probes;
      finish(*jobs[j], result, *jobs[j]->record);
    }
    return n_histories;
  } catch (const std::exception& error) {
    if (jobs.size() == 1) {
      jobs.front()->record->failure = error.what();
      return 0;
    }
  }
  const auto middle = jobs.begin() + static_cast<std::ptrdiff_t>(jobs.size() / 2);
  return run_jobs({jobs.begin(), middle}, bodies) + run_jobs({middle, jobs.end()}, bodies);
}

long run_batch(SoakRecord* first, std::size_t n, BodyStore& bodies) {
  std::vector<Job> jobs(n);
  for_each_in_parallel(n, [&](std::size_t i) { jobs[i] = begin(first[i]); });
  std::vector<const Job*> ready;
  for (const auto& job : jobs)
    if (job.prepared) ready.push_back(&job);
  return run_jobs(ready, bodies);
}

}  // namespace

bool SoakError::is_finite() const {
  return std::isfinite(mdr) && std::isfinite(fe) && !std::isnan(bar);
}

double SoakError::share() const {
  return std::abs(error()) / (bar + roundoff);
}

bool SoakError::covered() const {
  return share() <= 1;
}

std::optional<std::size_t> SoakRecord::worst() const {
  std::optional<std::size_t> worst;
  for (std::size_t q = 0; q < errors.size(); ++q)
    if (errors[q] && (!worst || !(errors[q]->share() <= errors[*worst]->share()))) worst = q;
  return worst;
}

std::string failure_of(const SoakRecord& record) {
  if (!record.failure.empty()) return record.failure;
  const auto worst = record.worst();
  if (!worst) return "nothing was compared";
  for (std::size_t q = 0; q < record.errors.size(); ++q)
    if (record.errors[q] && !record.errors[q]->is_finite())
      return fmt::format("{}: MDR says {}, the finite elements {}, their bar {}", soak_quantities[q],
                         record.errors[q]->mdr, record.errors[q]->fe, record.errors[q]->bar);
  const auto& e = *record.errors[*worst];
  if (e.covered()) return "";
  return fmt::format("{}: the error {:.1e} is above its bar {:.1e}", soak_quantities[*worst], e.error(), e.bar);
}

SoakRun run_soak(const SoakOptions& options, const std::function<void(std::size_t)>& after_batch) {
  Stopwatch watch;
  SoakRun run;
  run.seed = options.seed;
  run.records.resize(options.only ? 1 : options.n_cases);
  for (std::size_t i = 0; i < run.records.size(); ++i) run.records[i].draw = {options.seed, options.only.value_or(i)};
  BodyStore bodies([](const BodySpecification& specification) { return make_body(specification); });
  for (std::size_t i = 0; i < run.records.size(); i += options.batch) {
    const std::size_t n = std::min(options.batch, run.records.size() - i);
    run.n_histories += run_batch(&run.records[i], n, bodies);
    if (const auto bytes = resident_bytes()) run.memory.push_back({i + n, *bytes});
    after_batch(i + n);
  }
  run.seconds = watch.lap();
  return run;
}

}  // namespace fretval
