#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/proof.h"
#include "comparison/reference/normal_responses.h"
#include "comparison/support/ranks.h"

namespace fretval {

/// The part of a tolerance that a difference uses, among the tolerances that were asked for.
struct ToleranceUse {
  double share = -1;      ///< of the tolerance; negative: nothing was compared
  std::string text = {};  ///< the quantity, the case, the difference and the tolerance
};

/// The largest use of a tolerance in a result.json.
ToleranceUse largest_use(const nlohmann::ordered_json& result);

/// Result of one case of a batch.
struct BatchLine {
  std::string name;
  Outcome outcome = Outcome::not_proved;
  std::string failure;  ///< not empty: the numerics failed on this case, with this message
  ToleranceUse largest_use = {};
  std::string answer = {};  ///< for people, see answer_text
  std::string json = {};    ///< result.json in one line
  double seconds = 0;

  [[nodiscard]] bool failed() const { return !failure.empty(); }
};

/// Pieces of work of a fraction of a second each, handed out like the cases, after them.
struct BesideCases {
  std::size_t n = 0;
  std::function<std::string(std::size_t)> compute;     ///< by any thread of any rank
  std::function<void(std::size_t, std::string)> take;  ///< takes a result; never called twice for one number
};

struct BatchOptions {
  Proof proof = Proof::tolerance;
  std::filesystem::path output = {};  ///< empty: nothing is written
  /// Called after each case, one call at a time.
  std::function<void(const BatchLine&)> progress = [](const BatchLine&) {};
  /// Called on the way through a long case, by any thread: its name, the share that is done, and its present state in
  /// words.
  std::function<void(const std::string& name, double share, const std::string& what)> under_way = {};
  BesideCases beside = {};
};

/// Computes one case and writes its folder.
BatchLine computed_line(const PreparedCase& prepared, const BatchOptions& options, BodyStore& bodies,
                        NormalResponses& references);

/// Computes all cases, on all cores, with shared bodies. bodies: store of the bodies, which are made if they are not
/// there. Each case writes its folder under the output when it is done. What a folder holds from an earlier run no
/// longer counts as a result from then on, also if the numerics of the case fail now. The lines come in the order of
/// the cases.
std::vector<BatchLine> run_batch(const std::vector<PreparedCase>& cases, const BatchOptions& options,
                                 BodyStore& bodies);

/// What an earlier run has written about a case, if that is what this run would write: the result is whole, of the same
/// version of the program, the same inputs and as far proved, and no file that the case reads is newer. Empty: compute
/// it. output: folder of the results.
std::optional<BatchLine> kept_line(const PreparedCase& prepared, Proof proof, const std::filesystem::path& output);

/// run_batch() on all ranks, which ask the first one for cases. Returns on the first rank the lines of all cases, equal
/// to those of run_batch() but for their seconds; on the others none. The work beside the cases is handed out in the
/// same way. All ranks call it, with the same cases, options and threads of their own; the folder of a case is written
/// by the rank that computes it, progress is called on the first one. bodies: the store of this rank. Bodies of
/// from_dofs dofs or more are made by all ranks together, while the cases go on.
///
/// give_up: called where a rank meets anything but failing numerics, by any thread; it has to end all ranks.
std::vector<BatchLine> run_ranked_batch(const std::vector<PreparedCase>& cases, const BatchOptions& options,
                                        BodyStore& bodies, const Ranks& ranks, std::size_t from_dofs,
                                        const std::function<void(const std::exception_ptr&)>& give_up);

}  // namespace fretval
