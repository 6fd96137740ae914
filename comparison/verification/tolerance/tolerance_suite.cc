#include "comparison/verification/tolerance/tolerance_suite.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/accuracy/study_driver.h"
#include "comparison/support/parallel.h"
#include "comparison/verification/tolerance/tolerance_cases.h"
#include "comparison/verification/tolerance/tolerance_grid.h"

namespace fretval {
namespace {

constexpr double smallest_sure_time = 0.1;  // s

bool is_in_grid(std::size_t i) {
  return i % 10 == 0 || i % 10 == 3 || i % 10 == 6;
}

/// Errors, bars and findings of the quantities of a study; a quantity that it does not have becomes the failure.
TrueErrors true_errors(const PreparedCase& prepared, const Measures& exact, const Measures& measured,
                       const Measures& bars, std::string& failure) {
  TrueErrors errors;
  for (const auto& [quantity, value] : exact) {
    const auto found = measured.find(quantity);
    if (found == measured.end()) {
      failure = "no " + quantity;
      continue;
    }
    const auto bar = bars.find(quantity);
    errors[quantity] = {found->second - value, tolerance_of(prepared.tolerances, quantity),
                        bar == bars.end() ? std::numeric_limits<double>::infinity() : bar->second};
  }
  return errors;
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
  const auto wanted = measures_of(exact, units, prepared.fem.worn_edge.has_value());
  Measures bars;
  for (const auto& [quantity, bar] : study.budget) bars[quantity] = bar.total();
  record.errors = true_errors(prepared, wanted, measures_of(study.answer.fe, units), bars, record.failure);
  const auto& cheapest = study.cheapest.value();
  record.economised = {cheapest.resolutions,
                       true_errors(prepared, wanted, cheapest.measures, cheapest.bars, record.failure), 0};
  return record;
}

template <class Property>
bool all_errors(const ToleranceRecord& record, Property property) {
  const auto all_of = [&](const TrueErrors& errors) {
    return std::all_of(errors.begin(), errors.end(), [&](const auto& entry) { return property(entry.second); });
  };
  return all_of(record.errors) && all_of(record.economised.errors);
}

}  // namespace

bool ToleranceRecord::meets() const {
  return all_errors(*this, [](const TrueError& e) { return e.meets(); });
}

bool ToleranceRecord::covered() const {
  return all_errors(*this, [](const TrueError& e) { return e.covered(); });
}

bool ToleranceRecord::inconclusive() const {
  return !all_errors(*this, [](const TrueError& e) { return e.finding() != Verdict::inconclusive; });
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
                                               const std::vector<MdrAnswer>& exact) {
  // A study waits for its own answers, and all of them for one factorisation at a time: one more than there are cores
  // keeps these busy. Those that take longest come first.
  std::vector<std::size_t> order(cases.size());
  std::iota(order.begin(), order.end(), 0);
  const auto settles_slowly = [&](std::size_t i) { return cases[i].fem.relaxation.viscosity > 0; };
  std::stable_partition(order.begin(), order.end(), settles_slowly);
  BodyStore bodies([](const BodySpecification& s) { return make_body(s); });
  std::vector<ToleranceRecord> records(cases.size());
  for_each_in_parallel(
      cases.size(),
      [&](std::size_t k) {
        const std::size_t i = order[k];
        std::vector<CaseStudy> alone;
        alone.emplace_back(cases[i], StudyDepth::economy);
        run_studies(alone, bodies);
        records[i] = record_of(cases[i], exact[i], alone.front().result());
      },
      n_cores() + 1);
  return records;
}

std::vector<ToleranceRecord> run_tolerance_suite(const ToleranceSuiteOptions& options) {
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
    for (auto& record : tolerance_records(cases, exact)) all.push_back(std::move(record));
  }
  if (options.costs) search_grid(searched, searched_exact, all);
  return all;
}

}  // namespace fretval
