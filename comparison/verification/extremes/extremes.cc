#include "comparison/verification/extremes/extremes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/study_driver.h"
#include "comparison/reference/mdr_answer.h"
#include "comparison/results/batch.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/verification/extremes/extreme_springs.h"
#include "comparison/verification/extremes/flat_mesh.h"

namespace fretval {
namespace {

// Below it, two numbers of order 1 are the same.
constexpr double roundoff = 1e-12;

/// A row on its way.
struct Job {
  std::optional<PreparedCase> prepared;  ///< empty: refused, or failed
  MdrAnswer exact = {};
};

PreparedCase prepare_row(const ExtremeRow& row, const std::string& name) {
  auto prepared = prepare({case_of(row.entries, name)}).front();
  if (row.ramp_cycles) {
    auto resolution = prepared.fem.resolution;
    resolution.n_ramp_cycles = *row.ramp_cycles;
    prepared.fem = at_resolution(std::move(prepared.fem), resolution);
  }
  return prepared;
}

/// Everything about a scene but its finite elements.
Job begin(const ExtremeRow& row, ExtremeRecord& record) {
  Job job;
  try {
    if (row.springs) record.errors = spring_errors(case_of(row.entries, row.value));
    job.prepared = prepare_row(row, row.family + ": " + row.value);
    job.exact = mdr_answer(job.prepared->mdr, mdr_normal_response(job.prepared->mdr));
  } catch (const InputError& error) {
    record.refusal = error.what();
  } catch (const std::exception& error) {
    record.malfunction = error.what();
    job.prepared.reset();
  }
  return job;
}

double shown(const std::string& quantity, double value) {
  return quantity == "normal_force_max" ? std::exp(value) : value;
}

ExtremeError error_of(const std::string& quantity, double exact, double fe, double tolerance,
                      const ErrorBudget& budget) {
  ExtremeError error{shown(quantity, exact), shown(quantity, fe), fe - exact, tolerance,
                     std::numeric_limits<double>::infinity()};
  const auto found = budget.find(quantity);
  if (found == budget.end()) return error;
  error.bar = found->second.total();
  if (const auto* largest = found->second.largest()) error.source = name_of(largest->source);
  return error;
}

void finish(const Job& job, const StudyResult& study, ExtremeRecord& record) {
  record.refusal = study.answer.failure;
  record.seconds = study.seconds;
  record.n_refinements = study.n_refinements;
  if (study.answer.body) {
    const auto& quality = study.answer.body->mesh_quality;
    record.size_ratio = quality.largest_edge / quality.smallest_edge;
    record.aspect_ratio = quality.max_aspect_ratio;
    for (const auto& [quantity, focus] : study.focus)
      record.size_ratio = std::max(record.size_ratio, quality.largest_edge / focus.ring);
  }
  if (!record.refusal.empty()) return;
  const auto& fem = job.prepared->fem;
  const auto exact = measures_of(job.exact, fem.units, fem.worn_edge.has_value());
  for (const auto& [quantity, value] : measures_of(study.answer.fe, fem.units))
    record.errors[quantity] =
        error_of(quantity, exact.at(quantity), value, tolerance_of(job.prepared->tolerances, quantity), study.budget);
}

std::vector<std::size_t> jobs_with(const std::vector<ExtremeRow>& rows, const std::vector<Job>& jobs,
                                   double flattening) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (jobs[i].prepared && rows[i].flattening == flattening) chosen.push_back(i);
  return chosen;
}

Body make_flat_body(const BodySpecification& specification, double flattening) {
  if (flattening == 1) return make_body(specification);
  const auto& nodes = specification.contact_nodes;
  return make_body(flattened(mesh_of(specification), flattening, nodes[1], nodes.back()), "flattened mesh",
                   specification.degree, specification.tangential);
}

void run_studies_of(const std::vector<std::size_t>& chosen, const std::vector<Job>& jobs, double flattening,
                    std::vector<ExtremeRecord>& records) {
  std::vector<CaseStudy> studies;
  studies.reserve(chosen.size());
  for (const std::size_t i : chosen) studies.emplace_back(*jobs[i].prepared, StudyDepth::proof);
  run_studies(studies, [&](const BodySpecification& s) { return make_flat_body(s, flattening); });
  for (std::size_t s = 0; s < chosen.size(); ++s) finish(jobs[chosen[s]], studies[s].result(), records[chosen[s]]);
}

std::string refusal_failure_of(const ExtremeRecord& record) {
  const auto& expected = record.row.refusal;
  if (expected.empty()) return record.refusal.empty() ? "" : "refused: " + record.refusal;
  if (record.refusal.empty()) return fmt::format("not refused; the message should say: {}", expected);
  if (record.refusal.find(expected) == std::string::npos)
    return fmt::format("refused without the words: {}: {}", expected, record.refusal);
  return "";
}

std::string failure_of(const std::string& quantity, const ExtremeError& e) {
  if (!e.is_finite()) return fmt::format("{}: the error is {}, its bar {}", quantity, e.error, e.bar);
  if (!e.covered()) return fmt::format("{}: the error {:.1e} is above its bar {:.1e}", quantity, e.error, e.bar);
  if (std::abs(e.error) > e.tolerance && e.bar <= e.tolerance)
    return fmt::format("{}: the error {:.1e} is above its tolerance {:.0e}", quantity, e.error, e.tolerance);
  return "";
}

}  // namespace

bool ExtremeError::is_finite() const {
  return std::isfinite(mdr) && std::isfinite(fe) && std::isfinite(error) && std::isfinite(bar);
}

bool ExtremeError::covered() const {
  return std::abs(error) <= bar + roundoff;
}

const char* name_of(ExtremeVerdict verdict) {
  switch (verdict) {
    case ExtremeVerdict::agrees:
      return "agrees";
    case ExtremeVerdict::inconclusive:
      return "inconclusive";
    case ExtremeVerdict::refused:
      return "refused";
    case ExtremeVerdict::fails:
      break;
  }
  return "FAIL";
}

std::string failure_of(const ExtremeRecord& record) {
  if (!record.malfunction.empty()) return record.malfunction;
  std::string failure = refusal_failure_of(record);
  if (!failure.empty()) return failure;
  const bool has_answer = record.row.refusal.empty() || record.row.springs;
  if (has_answer && record.errors.empty()) return "nothing was compared";
  for (const auto& [quantity, error] : record.errors) {
    failure = failure_of(quantity, error);
    if (!failure.empty()) return failure;
  }
  return "";
}

ExtremeVerdict verdict_of(const ExtremeRecord& record) {
  if (!failure_of(record).empty()) return ExtremeVerdict::fails;
  if (!record.row.refusal.empty()) return ExtremeVerdict::refused;
  const bool wide = std::any_of(record.errors.begin(), record.errors.end(),
                                [](const auto& entry) { return entry.second.bar > entry.second.tolerance; });
  return wide ? ExtremeVerdict::inconclusive : ExtremeVerdict::agrees;
}

std::size_t count(const std::vector<ExtremeRecord>& records, ExtremeVerdict verdict) {
  return static_cast<std::size_t>(std::count_if(
      records.begin(), records.end(), [&](const ExtremeRecord& record) { return verdict_of(record) == verdict; }));
}

std::vector<ExtremeRecord> run_extremes(const std::vector<ExtremeRow>& rows) {
  std::vector<ExtremeRecord> records(rows.size());
  std::vector<Job> jobs(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) records[i].row = rows[i];
  for_each_in_parallel(rows.size(), [&](std::size_t i) { jobs[i] = begin(rows[i], records[i]); });
  std::vector<double> flattenings;
  for (const auto& row : rows)
    if (std::find(flattenings.begin(), flattenings.end(), row.flattening) == flattenings.end())
      flattenings.push_back(row.flattening);
  for (const double flattening : flattenings)
    run_studies_of(jobs_with(rows, jobs, flattening), jobs, flattening, records);
  return records;
}

}  // namespace fretval
