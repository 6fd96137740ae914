#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "comparison/accuracy/proof.h"
#include "comparison/command_line/store_command.h"

namespace fretval {

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

}  // namespace fretval
