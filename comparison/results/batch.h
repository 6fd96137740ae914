#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "comparison/accuracy/case_study.h"
#include "comparison/results/case_result.h"

namespace fretval {

/// Checks everything about the cases that can be checked before the first one is computed. Throws InputError; bad
/// values that only the reference refuses are reported with the file's name.
std::vector<PreparedCase> prepare(const std::vector<Case>& cases);

/// One line of the batch's outcome.
struct BatchLine {
  std::string name;
  bool pass = false;
  std::string failure;  ///< not empty: the numerics failed on this case, with this message
  Comparison verdict;
};

struct BatchHooks {
  /// Makes the body for a specification; by default on a generated mesh.
  std::function<Body(const BodySpecification&)> make_body = [](const BodySpecification& s) {
    return fretval::make_body(s);
  };
  /// Called after each case, one call at a time.
  std::function<void(const BatchLine&, std::size_t n_done, std::size_t n_cases)> progress = [](auto&&...) {};
  /// Of all cases, but those that ask to be economised go on from the proof to that.
  StudyDepth depth = StudyDepth::proof;
};

/// Computes all cases; those that start from one body go on together, so that they share bodies and normal histories
/// (see run_probes). Each case writes its folder under `output` when it is done, one with fields when the cases that
/// started with it are; with an empty path nothing is written. What a folder holds from an earlier run no longer counts
/// as a result from then on, also if the numerics of the case fail now.
/// The lines come in the order of the cases.
std::vector<BatchLine> run_batch(const std::vector<PreparedCase>& cases, const std::filesystem::path& output,
                                 const BatchHooks& hooks);

/// What MDR says and whether finite elements agree, from the result of a study.
CaseResult result_of(const PreparedCase& prepared, const mdr::NormalResponse& reference, StudyResult&& study);

}  // namespace fretval
