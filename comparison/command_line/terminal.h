#pragma once

#include <string>
#include <vector>

#include "comparison/run/batch.h"

namespace fretval {

/// "fretting: agrees" or what else became of a case, for the log.
std::string outcome_text(const BatchLine& line);

/// The answer to a single case, see answer_text.
void print_answer(const BatchLine& line);

/// A line of the standard output, at once.
void print_line(const std::string& line);

/// On stdout the values of both methods, a table; then a line per case file: how many of its cases agree, and which
/// comes closest to its tolerance; every failed case.
void print_verdicts(const std::vector<BatchLine>& lines);

}  // namespace fretval
