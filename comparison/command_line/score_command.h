#pragma once

#include <string>

namespace fretval {

struct ScoreOptions {
  std::string benchmark;           ///< its name in docs/benchmarks.md
  std::string tolerance = "1e-2";  ///< a share, as "1 %"
  bool json = false;
};

/// Compares the numbers of another code, one row of a CSV file, with a benchmark; prints them beside both methods.
/// Returns the exit code: that of disagreement where one is farther off than the tolerance. Throws InputError.
int run_score(const std::string& file, const ScoreOptions& options);

}  // namespace fretval
