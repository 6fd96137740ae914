#pragma once

#include <cstddef>
#include <string>

namespace fretval {

/// Throws InputError unless the header of a CSV file names the unit of every column: a table in millimetres that is
/// read in metres is another case. Also if it is no table of n_columns numbers a line (see mdr/support/csv.h).
void require_units(const std::string& file, std::size_t n_columns);

}  // namespace fretval
