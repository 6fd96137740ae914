#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/proof.h"
#include "comparison/case_file/new_case.h"
#include "comparison/simulation/bodies/operator_store.h"
#include "comparison/verification/exact/convergence_rows.h"
#include "comparison/verification/suite.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fretval {

// What the verbs of the program are asked for, and what they do. They return the exit code.

/// The store of operators that a command line asks for.
struct StoreOptions {
  std::string folder;  ///< empty: none
  std::uint64_t limit = OperatorStore::usual_limit;
  bool none = false;
};

/// Adds --store (or $FRETVAL_STORE; otherwise the cache folder of the user) and --store-limit (or
/// $FRETVAL_STORE_LIMIT) to a verb; parsing fills them. The options have to outlive that.
void add_store_options(CLI::App& verb, StoreOptions& options);

/// The store of operators; null: none is asked for, or there is no folder for it.
std::shared_ptr<OperatorStore> store_of(const StoreOptions& options);

/// `fretval store`: prints what is in a store (list), reads it and prints what is damaged (verify: exit_disagree if
/// anything is), or removes everything (clear). Returns the exit code. Throws std::filesystem::filesystem_error, and
/// InputError where there is no store.
int run_store(const std::string& action, const StoreOptions& options);

/// Makes the folder of the file that an option names, before minutes of computing and not after. file: empty if none is
/// asked for. Throws InputError if the file is a folder.
void prepare_output_file(const char* option, const std::string& file);

/// `fretval new`: writes a commented case file, and the tables that it names; nothing that is there already is
/// overwritten. Returns the exit code, as do the functions below. Throws InputError.
int write_new_case(const std::filesystem::path& file, const NewCase& choice);

/// `fretval explain`: says what a case is and what finite elements would compute; of a sweep, of its first case.
int explain_case(const std::string& file);

/// `fretval explain --entries`: docs/case_file.md.
int print_entries();

/// `fretval compare`: says what changed from one folder of results to another; exit_disagree if a value has moved by
/// more than both its bars.
int compare_results(const std::filesystem::path& before, const std::filesystem::path& after);

/// Computes the speed-accuracy trade of the single case in a file, writes output/NAME/trade.json and prints the front,
/// the rates and the recommended settings; returns the exit code. Throws InputError, also for a sweep.
int run_trade(const std::string& file, const std::filesystem::path& output);

struct ScoreOptions {
  std::string benchmark;           ///< its name in docs/benchmarks.md
  std::string tolerance = "1e-2";  ///< a share, as "1 %"
  bool json = false;
};

/// Compares the numbers of another code, one row of a CSV file, with a benchmark; prints them beside both methods.
/// Returns the exit code: that of disagreement where one is farther off than the tolerance. Throws InputError.
int run_score(const std::string& file, const ScoreOptions& options);

struct MdrOptions {
  bool json = false;
  bool springs = false;  ///< also the transient spring foundation
  std::string fields;    ///< CSV file for the fields on the surface; empty: none
};

/// Prints the analytic answer to each case of a file, also to cases that finite elements do not cover; returns the exit
/// code. Throws InputError.
int run_mdr(const std::string& file, const MdrOptions& options);

struct RunOptions {
  std::vector<std::string> inputs;           ///< case files, and folders of case files
  std::filesystem::path output = "results";  ///< empty: nothing is kept, and there is no report
  Proof proof = Proof::tolerance;
  bool json = false;     ///< each result.json on a line of the standard output instead of the answer
  std::string junit;     ///< file for JUnit XML; empty: none
  bool resume = false;   ///< what an earlier run has written of a case is kept, see kept_line
  std::string baseline;  ///< folder of earlier results that none may depart from; empty: none
  StoreOptions store;
  std::size_t distribute_from = 1000000;  ///< bodies of so many dofs or more are made by all ranks together, if several
};

/// `fretval run`: MDR and finite elements, compared; writes the results and the report. `fretval check --cases` does
/// this without an output. Ranks that mpirun has started share the cases, and the first one tells and writes the
/// results. Returns the exit code.
int run_cases(const RunOptions& options);

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
  bool with_cycle = false;                       ///< suite random: forces and energies of a cycle as well
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

struct TrustOptions {
  bool json = false;
  std::optional<double> at_most;  ///< largest share by which MDR may be off; empty: any
  std::string output;             ///< folder of a report; empty: none
  std::string map;                ///< file of the maps; empty: a case
  StoreOptions store;
};

/// "5 %" or "0.05" as a share. Throws InputError for others, naming the option.
double share_of(const std::string& text, const char* option = "--at-most");

/// Prints how far MDR can be trusted in the single case of a file, and why; returns the exit code: that of
/// disagreement where a radius is off by more than at_most for sure. Throws InputError, also for a sweep.
int run_trust(const std::string& file, const TrustOptions& options);

/// Computes the maps of MDR's error (trust/map.h) and writes them to the file, which is replaced when all is there.
int run_map(const TrustOptions& options);

}  // namespace fretval
