#pragma once

#include <filesystem>
#include <string>

#include "comparison/case_file/new_case.h"

namespace fretval {

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

}  // namespace fretval
