#include "comparison/tolerance_suite.h"

#include <algorithm>
#include <limits>

#include "comparison/measures.h"
#include "comparison/parallel.h"
#include "comparison/study_driver.h"
#include "comparison/tolerance_cases.h"
#include "comparison/tolerance_grid.h"

namespace fretval {
namespace {

constexpr double smallest_sure_time = 0.1;  // s

bool is_in_grid(std::size_t i) {
  return i % 10 == 0 || i % 10 == 3 || i % 10 == 6;
}

ToleranceRecord record_of(const PreparedCase& prepared, const MdrAnswer& exact, const StudyResult& study) {
  ToleranceRecord record{};
  record.name = prepared.scene.name;
  record.tolerance = prepared.scene.tolerance;
  record.failure = study.answer.failure;
  record.resolution = study.resolution;
  record.focus = study.focus;
  record.n_refinements = study.n_refinements;
  record.n_probes = study.n_probes;
  record.seconds = study.seconds;
  record.budget = study.budget;
  if (!record.failure.empty()) return record;
  const auto& units = prepared.fem.units;
  const auto fe = measures_of(study.answer.fe, units);
  const auto verdict = compare(exact, study.answer.fe, units.length, prepared.tolerances, study.budget);
  for (const auto& [quantity, value] : measures_of(exact, units, prepared.fem.worn_edge.has_value())) {
    const auto measured = fe.find(quantity);
    const auto bar = study.budget.find(quantity);
    const auto judged = verdict.find(quantity);
    if (measured == fe.end() || judged == verdict.end()) {
      record.failure = "no " + quantity;
      continue;
    }
    record.errors[quantity] = {
        measured->second - value, judged->second.tolerance,
        bar == study.budget.end() ? std::numeric_limits<double>::infinity() : bar->second.total(),
        judged->second.finding};
  }
  return record;
}

template <class Property>
bool all_errors(const ToleranceRecord& record, Property property) {
  return std::all_of(record.errors.begin(), record.errors.end(),
                     [&](const auto& entry) { return property(entry.second); });
}

}  // namespace

bool ToleranceRecord::meets() const {
  return all_errors(*this, [](const TrueError& e) { return e.meets(); });
}

bool ToleranceRecord::covered() const {
  return all_errors(*this, [](const TrueError& e) { return e.covered(); });
}

bool ToleranceRecord::inconclusive() const {
  return !all_errors(*this, [](const TrueError& e) { return e.finding != Finding::inconclusive; });
}

Body make_timed_body(const BodySpecification& specification) {
  Body body = make_body(specification);
  if (body.cost.total() >= smallest_sure_time) return body;
  std::vector<BodyCost> costs{body.cost, make_body(specification).cost, make_body(specification).cost};
  std::sort(costs.begin(), costs.end(), [](const BodyCost& a, const BodyCost& b) { return a.total() < b.total(); });
  body.cost = costs[1];
  return body;
}

std::vector<MdrAnswer> exact_answers(const std::vector<PreparedCase>& cases) {
  std::vector<MdrAnswer> answers(cases.size());
  for_each_in_parallel(
      cases.size(), [&](std::size_t i) { answers[i] = mdr_answer(cases[i].mdr, mdr_normal_response(cases[i].mdr)); });
  return answers;
}

std::vector<ToleranceRecord> tolerance_records(const std::vector<PreparedCase>& cases,
                                               const std::vector<MdrAnswer>& exact, Schedule schedule) {
  std::vector<CaseStudy> studies;
  for (const auto& prepared : cases) studies.emplace_back(prepared, true);
  run_studies(
      studies, [](const BodySpecification& s) { return make_body(s); }, schedule);
  std::vector<ToleranceRecord> records;
  for (std::size_t i = 0; i < cases.size(); ++i) records.push_back(record_of(cases[i], exact[i], studies[i].result()));
  return records;
}

std::vector<ToleranceRecord> run_tolerance_suite(const ToleranceSuiteOptions& options) {
  const auto schedule = options.costs ? Schedule::exclusive : Schedule::overlapped;
  std::vector<ToleranceRecord> all;
  std::vector<MdrAnswer> exact;
  std::vector<PreparedCase> searched;
  std::vector<MdrAnswer> searched_exact;
  for (const double tolerance : options.tolerances) {
    const auto cases = prepare(tolerance_cases(tolerance));
    if (exact.empty()) {
      exact = exact_answers(cases);
      for (std::size_t i = 0; i < cases.size(); ++i) {
        if (!is_in_grid(i)) continue;
        searched.push_back(cases[i]);
        searched_exact.push_back(exact[i]);
      }
    }
    for (auto& record : tolerance_records(cases, exact, schedule)) all.push_back(std::move(record));
  }
  if (options.costs) search_grid(searched, searched_exact, all);
  return all;
}

}  // namespace fretval
