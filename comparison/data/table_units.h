#pragma once

#include <string>
#include <vector>

#include "mdr/support/csv_columns.h"

namespace fretval {

/// Throws InputError unless the header of a table names the unit of every wanted column but that of a ratio: a table in
/// millimetres that is read in metres is another case. Throws it also for a table without these columns (see
/// mdr/support/csv_columns.h). Returns a sentence on what is skipped, "wear.csv: skipped: column T"; empty: nothing.
std::string require_units(const std::string& file, const std::vector<mdr::WantedColumn>& wanted);

/// What the columns t, d, u_x, F_N and F_x of a rig, in this order, are called, and which units they may have.
const std::vector<mdr::ColumnKind>& rig_columns();

/// That sentence for a table that has been read.
std::string skipped_text(const std::string& file, const mdr::ChosenColumns& chosen);

}  // namespace fretval
