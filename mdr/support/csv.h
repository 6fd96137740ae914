#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

namespace fretval::mdr {

/// A table of numbers as read from a text file.
struct CsvColumns {
  std::vector<std::string> names;            ///< of the columns; empty if the file has no header
  std::vector<std::string> units;            ///< of the columns; empty if the file has no second header line
  std::vector<std::vector<double>> columns;  ///< all of the same length, at least 1; finite
  std::vector<int> line_of_row;              ///< line of the file, from 1, that each row stands in
};

/// Reads a table of n_columns >= 1 numbers a line, the same in every locale.
///
/// Values are separated by semicolons, commas, tabs or blanks and have a decimal point. Up to two header lines may
/// precede the rows: names, then units. Blank lines and whatever follows a # are skipped; a byte order mark and any
/// line ending are accepted. A line is taken for a header only if no value in it begins like a number, so that a
/// spoilt first row is an error.
///
/// Throws std::invalid_argument that names the source, the line, its text and what would be valid: wrong number of
/// values, no number, NaN or infinity, beyond the range of double, decimal comma, binary content, no rows, over a
/// million rows, a line of over 10000 characters, an unreadable stream.
CsvColumns read_csv(std::istream& stream, const std::string& source_name, std::size_t n_columns);

}  // namespace fretval::mdr
