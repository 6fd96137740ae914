#pragma once

#include <istream>
#include <string>
#include <vector>

namespace fretval::mdr {

/// A line of a text file, in UTF-8 and without its ending.
struct TextLine {
  int number;  ///< in the file, from 1
  std::string text;
};

/// The lines of a text file as instruments write them: UTF-8 with or without a byte order mark, UTF-16 with one, or
/// Latin-1 (Windows 1252), which a line is taken for that is no UTF-8; endings LF, CR or CR LF. Throws
/// std::invalid_argument that names the source and the line for a zero byte, a line of over 10000 bytes, more than
/// 1100000 lines, or a stream that cannot be read.
std::vector<TextLine> read_lines(std::istream& stream, const std::string& source_name);

/// Throws std::invalid_argument: source, line, its beginning and the problem.
[[noreturn]] void fail_at(const std::string& source_name, const TextLine& line, const std::string& problem);

}  // namespace fretval::mdr
