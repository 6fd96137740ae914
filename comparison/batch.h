#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "comparison/body.h"
#include "comparison/outcome.h"

namespace fretval {

/// A case ready to be computed.
struct PreparedCase {
  Case scene;
  MdrScene mdr;
  FemScene fem;
  Tolerances tolerances;
};

/// Checks everything about the cases that can be checked before the first one is computed. Throws InputError; bad
/// values that only the reference refuses are reported with the file's name.
std::vector<PreparedCase> prepare(const std::vector<Case>& cases);

/// One line of the batch's outcome.
struct BatchLine {
  std::string name;
  bool pass = false;
  std::string failure;  ///< not empty: the numerics failed on this case, with this message
  Verdict verdict;
};

struct BatchHooks {
  /// Makes the body for a specification; by default on a generated mesh.
  std::function<Body(const BodySpecification&)> make_body = [](const BodySpecification& s) {
    return fretval::make_body(s);
  };
  /// Called after each case, one call at a time.
  std::function<void(const BatchLine&, std::size_t n_done, std::size_t n_cases)> progress = [](auto&&...) {};
};

/// Computes all cases. Work is shared: one body per specification, one normal history per normal problem (at nu = 1/2
/// it does not see the tangential motion); then the friction histories run on all cores. Each case writes its folder
/// under `output` when it is done; with an empty path nothing is written. The lines come in the order of the cases.
std::vector<BatchLine> run_batch(const std::vector<PreparedCase>& cases, const std::filesystem::path& output,
                                 const BatchHooks& hooks);

}  // namespace fretval
