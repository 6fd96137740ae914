#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "comparison/case/case.h"
#include "mdr/support/csv_columns.h"

namespace fretval {

/// What a function makes of a file. Where it throws std::invalid_argument, this throws an InputError that names the
/// file.
template <class Read>
auto input_from(const std::string& file, const Read& read) {
  try {
    return read();
  } catch (const std::invalid_argument& error) {
    const std::string message = error.what();
    throw InputError(message.find(file) == std::string::npos ? file + ": " + message : message);
  }
}

/// Takes the columns of a table into SI. Throws std::invalid_argument for an unknown unit.
void take_into_si(const std::string& file, const std::vector<mdr::WantedColumn>& wanted, mdr::ChosenColumns& chosen);

/// Throws InputError unless the header of a table names the unit of every wanted column but that of a ratio: a table in
/// millimetres that is read in metres is another case. Throws it also for a table without these columns (see
/// mdr/support/csv_columns.h). Returns a sentence on what is skipped, "wear.csv: skipped: column T"; empty: nothing.
std::string require_units(const std::string& file, const std::vector<mdr::WantedColumn>& wanted);

/// What the columns t, d, u_x, F_N and F_x of a rig, in this order, are called, and which units they may have.
const std::vector<mdr::ColumnKind>& rig_columns();

/// That sentence for a table that has been read.
std::string skipped_text(const std::string& file, const mdr::ChosenColumns& chosen);

}  // namespace fretval
