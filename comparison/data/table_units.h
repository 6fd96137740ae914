#pragma once

#include <string>
#include <vector>

#include "mdr/support/csv_columns.h"

namespace fretval {

/// Throws InputError unless the header of a table names the unit of every wanted column but that of a ratio: a table in
/// millimetres that is read in metres is another case. Also if it is no such table (see mdr/support/csv_columns.h).
/// Returns in a sentence what is skipped, "wear.csv: skipped: column T"; empty: nothing.
std::string require_units(const std::string& file, const std::vector<mdr::WantedColumn>& wanted);

/// The sentence of a table that has been read.
std::string skipped_text(const std::string& file, const mdr::ChosenColumns& chosen);

}  // namespace fretval
