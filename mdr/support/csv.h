#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mdr/support/text_lines.h"

namespace fretval::mdr {

/// A table of numbers as read from a text file.
struct CsvColumns {
  std::vector<std::string> names;            ///< of the columns; empty if the file has no header
  std::vector<std::string> units;            ///< of the columns; empty if the file names none beside the names
  std::vector<std::vector<double>> columns;  ///< all of the same length, at least 1; finite
  std::vector<int> line_of_row;              ///< line of the file, from 1, that each row stands in
};

/// Reads a table of n_columns >= 1 numbers a line, the same in every locale.
///
/// Values are separated by semicolons, commas, tabs or blanks. They have a decimal point or, between semicolons or
/// tabs, a decimal comma; all of it the same in all of the file. Up to two header lines may precede the rows: names,
/// then units. Blank lines and whatever follows a # are skipped; encodings and endings of lines are those of
/// read_lines. A line is taken for a header only if no value in it begins like a number, so that a spoilt first row is
/// an error.
///
/// Throws std::invalid_argument that names the source, the line, its text and what would be valid: wrong number of
/// values, no number, NaN or infinity, beyond the range of double, a decimal comma that is not told from a separator,
/// binary content, no rows, over a million rows, an unreadable stream.
CsvColumns read_csv(std::istream& stream, const std::string& source_name, std::size_t n_columns);

/// The columns of lines that have been read.
CsvColumns read_csv(const std::vector<TextLine>& lines, const std::string& source_name, std::size_t n_columns);

/// A line of a table, taken apart: its values without blanks and quotation marks around them.
struct CsvFields {
  std::vector<std::string> values;
  char separator;  ///< semicolon, comma, tab or blank
};
CsvFields split_fields(std::string_view line);

bool begins_like_number(std::string_view field);

/// "Hz, MPa, 1": the unit of a ratio is written as a number.
bool are_units(const std::vector<std::string>& fields);

/// Numbers of one file, all with decimal points or, between semicolons or tabs, all with decimal commas. Throws
/// std::invalid_argument as read_csv does.
class NumberReader {
 public:
  explicit NumberReader(std::string source_name) : source_name_(std::move(source_name)) {}
  /// Announces a row whose values are read next. All rows have the same separator; tabs and blanks may take turns.
  void begin_row(const TextLine& line, const CsvFields& fields);
  double read(const TextLine& line, const std::string& field);

 private:
  std::string source_name_;
  char separator_ = ' ';
  std::optional<char> before_;  ///< separator of the rows before
  bool any_point_ = false, any_comma_ = false;
};

}  // namespace fretval::mdr
