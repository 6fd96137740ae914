#include "comparison/run/batch.h"

#include <fmt/format.h>

#include <future>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "comparison/accuracy/data_shares.h"
#include "comparison/case/plausibility.h"
#include "comparison/case/test_duration.h"
#include "comparison/reference/half_space.h"
#include "comparison/reference/mdr_readings.h"
#include "comparison/reference/normal_responses.h"
#include "comparison/results/answer_text.h"
#include "comparison/results/case_result.h"
#include "comparison/results/verdict_text.h"
#include "comparison/run/estimate.h"
#include "comparison/simulation/compute_case.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"
#include "comparison/support/stopwatch.h"

namespace fretval {
namespace {

constexpr double unworn_beside_wear = 0.05;  // of the time that both take

/// The line of a result, with what is told and kept of it.
void finish(const CaseResult& result, const mdr::NormalResponse& reference, const BatchOptions& options,
            BatchLine& line) {
  line.outcome = outcome_of(result);
  const auto json = result_json(result);
  line.largest_use = largest_use(json);
  line.answer = answer_text(result, json);
  line.json = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  if (!options.output.empty()) write_result(result, json, reference, options.output / line.name);
}

/// Fields to write: those of the case file or, if it does not say, those for a single case that is proved.
Case::Fields fields_to_write(const Case& input, const BatchOptions& options) {
  if (options.output.empty()) return Case::Fields::none;
  const bool writes = !input.sweep && options.proof != Proof::none;
  return input.fields.value_or(writes ? Case::Fields::extremes : Case::Fields::none);
}

/// Adds the wear of the indenter to a result. Returns why it failed, or nothing.
std::string wear_off(const PreparedCase& prepared, const BatchOptions& options, BodyStore& bodies, CaseResult& result) {
  const bool in_the_plane = prepared.fem.kind == ContactKind::plane;
  WearOversight oversight;
  if (!options.output.empty()) oversight.checkpoints = options.output / prepared.input.name / "checkpoints";
  if (options.under_way)
    oversight.progress = [&](double share, double value) {
      const auto* what =
          in_the_plane ? "what sticks has shrunk to {:.2g} a" : "worn to {:.1e} from the limiting profile";
      options.under_way(prepared.input.name, unworn_beside_wear + (1 - unworn_beside_wear) * share,
                        fmt::format(fmt::runtime(what), value));
    };
  std::string failure;
  if (in_the_plane) {
    result.surface_wear = prove_surface_wear(prepared, result.mdr, result.fe, options.proof, bodies, oversight);
    failure = result.surface_wear->failure;
  } else {
    auto wear = prove_wear(prepared, result.mdr, result.fe, options.proof, bodies, oversight);
    failure = wear.failure;
    if (failure.empty()) add_wear(std::move(wear), result);
  }
  std::filesystem::remove_all(oversight.checkpoints);
  return failure;
}

/// Steps the answer once more with a second algorithm beside each step, and keeps by how much the two differ. Returns
/// why that is no confirmation, or nothing.
std::string confirm_by_second_algorithm(FemCase fem, BodyStore& bodies, ProvedAnswer& answer) {
  constexpr double enough = 1e-6;  // a residual of 1e-11 times the condition of the contact
  auto* surface = std::get_if<SurfaceAnswer>(&answer.fe.of_kind);
  if (!surface) return "";
  fem.full.second_algorithm = true;
  const auto again = compute_case(fem, answer.resolution, bodies);
  const double difference = std::get<SurfaceAnswer>(again.of_kind).history.second_difference.value();
  surface->history.second_difference = difference;
  if (difference <= enough) return "";
  return fmt::format(
      "a second algorithm, projected gradients, finds other tractions: they differ by {:.1e} of the "
      "largest, {:.0e} would be a confirmation",
      difference, enough);
}

/// MDR's answers to a case, as far as it holds.
struct Reference {
  std::shared_ptr<const mdr::NormalResponse> normal;
  MdrAnswers answers;
  Quantities errors;    ///< see PreparedCase::reference_errors
  std::string failure;  ///< why there is no answer, or empty
};

Reference reference_of(const PreparedCase& prepared, NormalResponses& references) {
  if (!prepared.is_compared())
    return {std::make_shared<const mdr::NormalResponse>(), {no_answer(prepared.mdr)}, {}, ""};
  try {
    auto normal = references.of(prepared.input, prepared.mdr);
    MdrAnswers answers{mdr_answer_with_cycle(prepared.mdr, *normal)};
    if (prepared.mdr.layer) answers.half_space = half_space_answer(prepared.input);
    auto errors =
        uncertainties_of(compared_readings_of(answers.own), scales_of(answers.own, prepared.fem.units.length));
    return {std::move(normal), std::move(answers), std::move(errors), ""};
  } catch (const std::runtime_error& error) {
    return {{}, {}, {}, error.what()};
  }
}

BatchLine run_case(const PreparedCase& asked, const BatchOptions& options, BodyStore& bodies,
                   NormalResponses& references) {
  BatchLine line;
  line.name = asked.input.name;
  const auto folder = options.output / line.name;
  line.failure = too_slow_for_forces(asked.input);
  if (!line.failure.empty()) {
    if (!options.output.empty()) withdraw_result(folder);
    return line;
  }
  PreparedCase prepared = asked;
  prepared.input.fields = fields_to_write(asked.input, options);
  if (prepared.fem.kind == ContactKind::plane) prepared.input.fields = Case::Fields::none;  // it has files of its own
  prepared.fem.keeps_body = prepared.input.fields != Case::Fields::none;
  const double share_of_unworn = wears(prepared) ? unworn_beside_wear : 1;
  ComputationsDone told;
  if (options.under_way)
    told = [&](int n_done, int n_known) {
      options.under_way(line.name, share_of_unworn * n_done / n_known,
                        fmt::format("{} of {} computations, more if the bars ask for them", n_done, n_known));
    };
  // MDR's springs step beside the finite elements, which first ask for their errors when they have bars.
  const auto reference = std::async(std::launch::async, [&] { return reference_of(asked, references); }).share();
  prepared.reference_errors = [reference] { return reference.get().errors; };
  auto fe = prove(prepared, options.proof, bodies, n_cores(), told);
  auto known = reference.get();
  line.failure = known.failure;
  if (!fe.failure.empty()) line.failure = fe.failure + hint_at_modulus(prepared.input);
  if (prepared.fem.keeps_body && fe.fe.body && is_too_large(fe.fe.body->n_dofs, bodies)) {
    log::warn(
        fmt::format("{}: no fields are written: no process has a body of {} dofs", line.name, fe.fe.body->n_dofs));
    prepared.input.fields = Case::Fields::none;
  }
  if (line.failure.empty() && prepared.input.contact.second_algorithm)
    line.failure = confirm_by_second_algorithm(prepared.fem, bodies, fe);
  if (!options.output.empty()) withdraw_result(folder);
  if (!line.failure.empty()) return line;
  add_data_shares(prepared.input, prepared.mdr, fe.budget);
  auto result = result_of(prepared, std::move(known.answers), options.proof, std::move(fe));
  if (wears(prepared)) line.failure = wear_off(prepared, options, bodies, result);
  if (!line.failure.empty()) return line;
  finish(result, *known.normal, options, line);
  return line;
}

}  // namespace

ToleranceUse largest_use(const nlohmann::ordered_json& result) {
  ToleranceUse largest;
  for (const auto& d : stored_differences(result)) {
    const double share = d.size / d.tolerance;
    if (!d.asked || !(share > largest.share)) continue;
    largest = {share, fmt::format("{} in {}, off by {:.1e} of {:.1e}{}", traits_of(d.quantity).title,
                                  result.at("name").get<std::string>(), d.size, d.tolerance,
                                  d.only_one ? ", only one of the two sticks" : "")};
  }
  return largest;
}

BatchLine computed_line(const PreparedCase& prepared, const BatchOptions& options, BodyStore& bodies,
                        NormalResponses& references) {
  Stopwatch watch;
  auto line = run_case(prepared, options, bodies, references);
  line.seconds = watch.lap();
  return line;
}

std::vector<BatchLine> run_batch(const std::vector<PreparedCase>& cases, const BatchOptions& options,
                                 BodyStore& bodies) {
  std::vector<BatchLine> lines(cases.size());
  const auto order = longest_first(cases, options.proof);
  NormalResponses references;
  std::mutex mutex;
  for_each_in_parallel(cases.size() + options.beside.n, [&](std::size_t i) {
    if (i >= cases.size()) {
      const std::size_t number = i - cases.size();
      return options.beside.take(number, options.beside.compute(number));
    }
    auto& line = lines[order[i]];
    line = computed_line(cases[order[i]], options, bodies, references);
    const std::lock_guard<std::mutex> lock(mutex);
    options.progress(line);
  });
  return lines;
}

}  // namespace fretval
