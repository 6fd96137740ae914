#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/verification/exact/convergence_rows.h"
#include "comparison/verification/suite.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fretval {

/// What the verb `check` is asked for.
struct CheckOptions {
  std::string suite = "small", junit, json;
  std::vector<std::string> inputs;               ///< the user's cases instead of a suite
  std::string meshes;                            ///< suite small
  std::vector<double> tolerances;                ///< suite tolerance
  std::string cases_folder;                      ///< suite tolerance; empty: case files are not written
  bool only_short = false;                       ///< suite extremes
  std::string family;                            ///< suite extremes; empty: all
  std::size_t n_cases = 10000;                   ///< suite random
  std::optional<std::uint64_t> seed;             ///< suite random; empty: a new one
  std::optional<std::size_t> only;               ///< suite random: the number of the one case
  std::string worst_folder;                      ///< suite random; empty: case files are not written
  std::map<const CLI::Option*, std::string> of;  ///< the suite that an option belongs to
};

/// Adds the options to the verb; parsing fills them. Both have to outlive that.
void add_check_options(CLI::App& verb, CheckOptions& options);

/// Runs the suite, prints its table, writes what was asked for; returns the exit code.
int run_check(const CheckOptions& options);

/// 3 if a case came to no answer although it should, 1 if anything else fails.
int exit_code_of(const SuiteRun& run);

/// The exit code of the suite `exact`: 1 if any row fails.
int exit_code_of(const std::vector<ConvergenceRow>& rows);

}  // namespace fretval
