#include "comparison/verification/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "comparison/accuracy/fe_readings.h"
#include "comparison/accuracy/prepared_case.h"
#include "comparison/case_file/case_file.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/run/estimate.h"
#include "comparison/support/parallel.h"
#include "comparison/support/progress.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Below it, two numbers of order 1 are the same.
constexpr double roundoff = 1e-12;

void take_bar(const ErrorBudget& budget, Quantity quantity, ComparedQuantity& compared) {
  const auto found = budget.find(quantity);
  compared.bar = found == budget.end() ? infinity : found->second.total();
  const ErrorShare* largest = found == budget.end() ? nullptr : found->second.largest();
  if (largest) compared.source = name_of(largest->source);
}

/// Values of finite elements beside MDR's. A value that they lack is not a number and fails, except the contact radius
/// of a worn profile, whose flank touches without pressure, and where nothing is refined, as coarse rings may not show
/// an edge.
void compare(const PreparedCase& prepared, const ProvedAnswer& answer, SuiteRow& row) {
  const auto& asked = row.asked;
  const auto& units = prepared.fem.units;
  const bool worn = prepared.fem.kind == ContactKind::worn;
  const auto reference =
      (asked.with_cycle ? mdr_answer_with_cycle : mdr_answer)(prepared.mdr, mdr_normal_response(prepared.mdr));
  const auto readings = compared_readings_of(reference);
  const auto scales = scales_of(reference, units.length);
  const auto mdr = compared_quantities(readings, scales, units), mdr_errors = uncertainties_of(readings, scales);
  const auto fe = quantities_of(answer.fe, units);
  for (const auto& [quantity, exact] : mdr) {
    if (traits_of(quantity).refined_for != RefinedFor::any_case && !asked.with_cycle) continue;
    const auto found = fe.find(quantity);
    const bool may_lack = asked.proof == Proof::bars || (worn && quantity == Quantity::contact_radius_max);
    if (found == fe.end() && may_lack) continue;
    ComparedQuantity compared{exact, found == fe.end() ? std::nan("") : found->second,
                              tolerance_of(prepared.tolerances, quantity), std::nullopt};
    if (const auto error = mdr_errors.find(quantity); error != mdr_errors.end()) compared.mdr_error = error->second;
    if (asked.proof != Proof::none) take_bar(answer.budget, quantity, compared);
    row.compared[quantity] = compared;
  }
  row.sliding = outcome_of_sliding(prepared.input, answer.fe, reference);
}

SuiteRow run_case(const SuiteCase& asked, BodyStore& bodies, std::size_t n_threads, const ComputationsDone& told) {
  SuiteRow row{asked};
  try {
    auto prepared = prepare({case_of(asked)}).front();
    if (asked.change) asked.change(prepared);
    const auto answer = prove(prepared, asked.proof, asked.bodies ? *asked.bodies : bodies, n_threads, told);
    row.refusal = answer.failure;
    row.seconds = answer.seconds;
    row.n_refinements = answer.n_refinements;
    row.n_computations = answer.cost.computations;
    if (row.refusal.empty()) compare(prepared, answer, row);
  } catch (const InputError& error) {
    row.refusal = error.what();
  } catch (const std::exception& error) {
    row.failure = error.what();
  }
  return row;
}

/// Expected seconds of each case by its title, where as many are computed at once as there are cores, and share their
/// bodies; refused cases take no time. Of more than a thousand cases some stand for the others.
std::map<std::string, double> expected_seconds(const std::vector<SuiteCase>& cases) {
  constexpr std::size_t enough = 1000;
  const std::size_t stride = 1 + (cases.size() - 1) / enough;
  std::vector<std::optional<PreparedCase>> sample((cases.size() + stride - 1) / stride);
  for_each_in_parallel(sample.size(), [&](std::size_t i) {
    const auto& asked = cases[i * stride];
    try {
      sample[i] = prepare({case_of(asked)}).front();
      if (asked.change) asked.change(*sample[i]);
    } catch (const std::exception&) {
      sample[i].reset();
    }
  });
  std::map<BodyDescription, std::size_t> n_sharing;
  for (const auto& one : sample)
    if (one) n_sharing[one->fem.body] += stride;
  std::map<std::string, double> expected;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const auto& asked = cases[i * stride];
    expected[title_of(asked)] = sample[i]
                                    ? estimated_seconds(*sample[i], asked.proof, n_sharing.at(sample[i]->fem.body)) /
                                          static_cast<double>(n_cores())
                                    : 0;
  }
  return expected;
}

std::string refusal_failure_of(const SuiteRow& row) {
  const auto& expected = row.asked.refusal;
  if (expected.empty()) return row.refusal.empty() ? "" : "refused: " + row.refusal;
  if (row.refusal.empty()) return fmt::format("not refused; the message should say: {}", expected);
  if (row.refusal.find(expected) == std::string::npos)
    return fmt::format("refused without the words: {}: {}", expected, row.refusal);
  return "";
}

std::string failure_of(const SuiteCase& asked, Quantity quantity, const ComparedQuantity& q) {
  const bool lacks_bar = q.bar && std::isinf(*q.bar) && asked.proof == Proof::tolerance;
  if (std::isinf(q.share()) || lacks_bar)
    return fmt::format("{}: MDR says {}, the finite elements {}, their bar is {}", traits_of(quantity).title, q.mdr,
                       q.fe, q.bar.value_or(0));
  if (q.share() > 1)
    return fmt::format("{}: the error {:.1e} is above its {} {:.1e}", traits_of(quantity).title, q.error(),
                       q.bar ? "bar" : "tolerance", q.bar.value_or(q.tolerance));
  if (asked.must_be_conclusive && q.has_wide_bar())
    return fmt::format("{}: the bar {:.1e} is wider than the tolerance {:.0e}", traits_of(quantity).title, *q.bar,
                       q.tolerance);
  return "";
}

}  // namespace

double ComparedQuantity::share() const {
  const double share = std::abs(error()) / (bar.value_or(tolerance) + mdr_error + roundoff);
  return std::isnan(share) ? infinity : share;
}

const char* name_of(RowVerdict verdict) {
  // In the order of the enumeration.
  static constexpr std::array names{"agrees", "inconclusive", "refused", "FAIL"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string failure_of(const SuiteRow& row) {
  if (!row.failure.empty()) return row.failure;
  std::string failure = refusal_failure_of(row);
  if (!failure.empty()) return failure;
  if (row.sliding == Outcome::disagree) return "only one method finds gross slip, or not where it has to";
  if (row.asked.refusal.empty() && row.compared.empty() && !row.sliding) return "nothing was compared";
  for (const auto& [quantity, compared] : row.compared) {
    failure = failure_of(row.asked, quantity, compared);
    if (!failure.empty()) return failure;
  }
  return "";
}

RowVerdict verdict_of(const SuiteRow& row) {
  if (!failure_of(row).empty()) return RowVerdict::fails;
  if (!row.asked.refusal.empty()) return RowVerdict::refused;
  const bool wide = std::any_of(row.compared.begin(), row.compared.end(),
                                [](const auto& entry) { return entry.second.has_wide_bar(); });
  return wide || row.sliding == Outcome::not_resolved ? RowVerdict::inconclusive : RowVerdict::agrees;
}

bool SuiteRun::passes() const {
  return !rows.empty() &&
         std::all_of(rows.begin(), rows.end(), [](const SuiteRow& row) { return failure_of(row).empty(); });
}

std::vector<SuiteRow> run_cases(const std::vector<SuiteCase>& cases, BodyStore& bodies) {
  std::vector<SuiteRow> rows(cases.size());
  const std::size_t n_threads = cases.size() < n_cores() ? n_cores() : 1;
  // All cases wait for one factorisation at a time: one more than there are cores keeps these busy.
  Progress progress(cases.size(), expected_seconds(cases));
  for_each_in_parallel(
      cases.size(),
      [&](std::size_t i) {
        const auto title = title_of(cases[i]);
        rows[i] = run_case(cases[i], bodies, n_threads, [&](int n_done, int n_known) {
          progress.under_way(title, static_cast<double>(n_done) / n_known,
                             fmt::format("{} of {} computations", n_done, n_known));
        });
        const auto failure = failure_of(rows[i]);
        progress.done(fmt::format("{}: {}", title, failure.empty() ? name_of(verdict_of(rows[i])) : failure),
                      failure.empty(), title);
      },
      n_cores() + 1);
  return rows;
}

SuiteRun run_suite(const std::string& name, const std::string& about, const std::vector<SuiteCase>& cases) {
  Stopwatch watch;
  BodyStore bodies;
  SuiteRun run{name, about, run_cases(cases, bodies)};
  run.seconds = watch.lap();
  return run;
}

Case case_of(const SuiteCase& suite_case) {
  Case input = read_case_text(suite_case.text, title_of(suite_case));
  input.name = title_of(suite_case);
  return input;
}

std::string title_of(const SuiteCase& suite_case) {
  return suite_case.family.empty() ? suite_case.name : suite_case.family + ": " + suite_case.name;
}

}  // namespace fretval
