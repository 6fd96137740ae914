#include "comparison/results/batch.h"

#include <fmt/format.h>

#include <map>
#include <set>

#include "comparison/accuracy/study_driver.h"
#include "comparison/case/plausibility.h"
#include "comparison/support/groups.h"
#include "comparison/support/log.h"
#include "comparison/support/parallel.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using Indices = std::vector<std::size_t>;

/// Normal responses of the spring foundation; a failure is kept as its message.
struct Reference {
  mdr::NormalResponse response;
  std::string failure;
};

Reference reference_of(const MdrCase& scene) {
  try {
    return {mdr_normal_response(scene), ""};
  } catch (const std::runtime_error& error) {
    return {{}, error.what()};
  }
}

/// By the index of the case; cases with the same normal problem share the work.
std::map<std::size_t, Reference> references_of(const std::vector<PreparedCase>& cases, const Indices& indices) {
  const auto groups = groups_of(indices, [&](std::size_t a, std::size_t b) {
    return same_normal_problem(cases[a].fem, cases[a].scene, cases[b].fem, cases[b].scene);
  });
  std::vector<Reference> computed(groups.size());
  for_each_in_parallel(groups.size(), [&](std::size_t g) { computed[g] = reference_of(cases[groups[g].front()].mdr); });
  std::map<std::size_t, Reference> all;
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t i : groups[g]) all[i] = computed[g];
  return all;
}

class Batch {
 public:
  Batch(const std::vector<PreparedCase>& cases, const fs::path& output, const BatchHooks& hooks)
      : cases_(cases), output_(output), hooks_(hooks), lines_(cases.size()) {}

  void run(const Indices& indices) {
    const auto references = references_of(cases_, indices);
    std::vector<CaseStudy> studies;
    for (const std::size_t i : indices) studies.emplace_back(cases_[i], depth_of(cases_[i]));
    std::vector<std::size_t> with_fields;  // they need bodies, which only this thread makes
    const auto finish_study = [&](std::size_t s) {
      finish(indices[s], studies[s].result(), references.at(indices[s]));
    };
    run_studies(studies, hooks_.make_body, [&](std::size_t s) {
      if (cases_[indices[s]].scene.fields == Case::Fields::none)
        finish_study(s);
      else
        with_fields.push_back(s);
    });
    for (const std::size_t s : with_fields) finish_study(s);
  }

  std::vector<BatchLine> take_lines() { return std::move(lines_); }

 private:
  [[nodiscard]] StudyDepth depth_of(const PreparedCase& prepared) const {
    return hooks_.depth == StudyDepth::proof && prepared.scene.economise ? StudyDepth::economy : hooks_.depth;
  }

  void finish(std::size_t index, StudyResult&& study, const Reference& reference) {
    const auto& prepared = cases_[index];
    auto& line = lines_[index];
    line.name = prepared.scene.name;
    line.failure = study.answer.failure.empty() ? reference.failure : study.answer.failure;
    if (study.cheapest)
      for (const auto& resolution : study.cheapest->resolutions)
        log::info(fmt::format("{}: cheapest settings that the proof covers: {}", line.name, text_of(resolution)));
    if (!output_.empty()) withdraw_result(output_ / line.name);
    if (line.failure.empty()) {
      const auto outcome = result_of(prepared, reference.response, std::move(study));
      line.verdict = outcome.verdict;
      line.pass = passes(line.verdict);
      if (!output_.empty()) write_result(outcome, reference.response, output_ / line.name, hooks_.make_body);
    }
    hooks_.progress(line, ++n_done_, cases_.size());
  }

  const std::vector<PreparedCase>& cases_;
  const fs::path& output_;
  const BatchHooks& hooks_;
  std::vector<BatchLine> lines_;
  std::size_t n_done_ = 0;
};

}  // namespace

CaseResult result_of(const PreparedCase& prepared, const mdr::NormalResponse& reference, StudyResult&& study) {
  CaseResult outcome{prepared.scene,
                     prepared.mdr,
                     at_resolution(prepared.fem, study.resolution),
                     mdr_answer(prepared.mdr, reference),
                     std::move(study),
                     {}};
  outcome.verdict = compare(outcome.mdr, outcome.study.answer.fe, prepared.fem.units.length, prepared.tolerances,
                            outcome.study.budget);
  return outcome;
}

std::vector<PreparedCase> prepare(const std::vector<Case>& cases) {
  std::vector<PreparedCase> prepared;
  std::set<std::string> names;
  for (const auto& scene : cases) {
    if (!names.insert(scene.name).second)
      throw InputError(
          fmt::format("{}: a case named {} is already there; case files need different names", scene.file, scene.name));
    try {
      const auto mdr = mdr_case(scene);
      prepared.push_back({scene, mdr, fem_case(scene, mdr), tolerances_of(scene.tolerance)});
      for (auto& warning : implausible_values(scene, mdr.profile))
        prepared.back().scene.warnings.push_back(std::move(warning));
    } catch (const std::invalid_argument& error) {
      throw InputError(fmt::format("{}: {}", scene.file, error.what()));
    }
  }
  return prepared;
}

std::vector<BatchLine> run_batch(const std::vector<PreparedCase>& cases, const fs::path& output,
                                 const BatchHooks& hooks) {
  std::map<BodySpecification, Indices> bodies;
  for (std::size_t i = 0; i < cases.size(); ++i) bodies[cases[i].fem.body].push_back(i);
  Batch batch(cases, output, hooks);
  for (const auto& [specification, indices] : bodies) batch.run(indices);
  return batch.take_lines();
}

}  // namespace fretval
