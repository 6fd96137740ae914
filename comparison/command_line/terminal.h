#pragma once

#include <string>
#include <vector>

#include "comparison/run/batch.h"

namespace fretval {

/// "fretting: agrees" or what else became of a case, for the log.
std::string outcome_text(const BatchLine& line);

/// Prints the answer to a single case, see answer_text.
void print_answer(const BatchLine& line);

/// Prints a line on the standard output at once, without a buffer.
void print_line(const std::string& line);

/// Prints the values of both methods as a table; then a line for each case file, with the number of its cases that
/// agree and the one closest to its tolerance; and every failed case.
void print_verdicts(const std::vector<BatchLine>& lines);

}  // namespace fretval
