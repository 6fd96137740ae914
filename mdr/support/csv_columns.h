#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "mdr/support/column_choice.h"
#include "mdr/support/csv.h"

namespace fretval::mdr {

struct ChosenColumns {
  CsvColumns csv;  ///< the wanted columns in their order; a missing optional one has no values
  std::vector<std::optional<std::size_t>> kind;  ///< of each wanted column; empty: an optional one that is missing
  /// What is left out of the table, "12 lines ahead of the columns, columns T, set"; empty: nothing.
  std::string skipped;
};

/// Reads the wanted columns of a table, wherever they stand in it. They are found in the first line of names that has
/// all of them, after any other lines, followed by a line of units or not, and by a row: first by their names; then,
/// what is left, by their units, if only one column can be meant. Units are those of the second line, or stand in
/// brackets or behind a stroke in the names, "f [Hz]", "f / Hz". A line of names may begin with #. Other columns may
/// hold anything. Without such a line the table has to consist of the wanted columns alone, see read_csv.
///
/// Throws std::invalid_argument as read_csv does, and if a column is missing, or it is not clear which one is meant.
ChosenColumns read_columns(std::istream& stream, const std::string& source_name,
                           const std::vector<WantedColumn>& wanted, InOrder in_order);

}  // namespace fretval::mdr
