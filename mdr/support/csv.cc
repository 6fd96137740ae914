#include "mdr/support/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace fretval::mdr {

namespace {

constexpr std::size_t max_rows = 1'000'000;
constexpr std::size_t max_line_length = 10'000;
constexpr std::string_view blanks = " \t";

struct Line {
  const std::string& source;
  int number;
  std::string text;
};

[[noreturn]] void fail(const Line& line, const std::string& problem) {
  std::string shown = line.text.substr(0, 60);
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < ' ') c = c == '\t' ? ' ' : '?';
  }
  throw std::invalid_argument(line.source + ", line " + std::to_string(line.number) + ", \"" + shown +
                              "\": " + problem);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// Next line without its ending, which is LF, CR or CR LF. Reads no more than it may keep.
bool read_line(std::istream& stream, Line& line) {
  line.text.clear();
  ++line.number;
  char c;
  bool any = false;
  while (stream.get(c)) {
    any = true;
    if (c == '\n') break;
    if (c == '\r') {
      if (stream.peek() == '\n') stream.get();
      break;
    }
    if (c == '\0') fail(line, "holds a zero byte; must be a text file");
    if (line.text.size() == max_line_length)
      fail(line, "must have at most " + std::to_string(max_line_length) + " characters");
    line.text += c;
  }
  if (stream.bad()) fail(line, "could not be read");
  return any;
}

std::vector<std::string_view> split_at(std::string_view text, char separator) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0;;) {
    const std::size_t end = text.find(separator, begin);
    fields.push_back(trimmed(text.substr(begin, end - begin)));
    if (end == std::string_view::npos) return fields;
    begin = end + 1;
  }
}

std::vector<std::string_view> split_at_blanks(std::string_view text) {
  std::vector<std::string_view> fields;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    fields.push_back(text.substr(0, end));
    text = trimmed(text.substr(end));
  }
  return fields;
}

bool begins_like_number(std::string_view field) {
  const auto is_digit = [&](std::size_t i) { return i < field.size() && field[i] >= '0' && field[i] <= '9'; };
  std::size_t i = 0;
  if (i < field.size() && (field[i] == '+' || field[i] == '-')) ++i;
  if (i < field.size() && (field[i] == '.' || field[i] == ',')) ++i;
  if (is_digit(i)) return true;
  double value;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);  // nan, inf
  return error == std::errc() && end == field.data() + field.size();
}

bool any_number(const std::vector<std::string_view>& fields) {
  return std::any_of(fields.begin(), fields.end(), begins_like_number);
}

// "Hz, MPa, 1": the unit of a ratio is written as a number.
bool are_units(const std::vector<std::string_view>& fields) {
  const auto n_ratios = std::count(fields.begin(), fields.end(), "1");
  return n_ratios < static_cast<std::ptrdiff_t>(fields.size()) &&
         n_ratios == std::count_if(fields.begin(), fields.end(), begins_like_number);
}

// A comma next to a blank, or without any blank in the line, separates; "1,5 2,5" holds decimal commas.
std::vector<std::string_view> split(std::string_view text) {
  if (text.find(';') != std::string_view::npos) return split_at(text, ';');
  if (text.find(',') == std::string_view::npos) return split_at_blanks(text);
  std::vector<std::string_view> by_comma = split_at(text, ',');
  const bool one_value_each = std::none_of(by_comma.begin(), by_comma.end(), [](std::string_view field) {
    return field.find_first_of(blanks) != std::string_view::npos;
  });
  if (one_value_each || !any_number(by_comma)) return by_comma;
  return split_at_blanks(text);
}

double number(const Line& line, std::string_view field) {
  const std::string quoted = "\"" + std::string(field.substr(0, 30)) + "\" ";
  if (field.empty()) fail(line, "has an empty value; must be a number");
  if (begins_like_number(field) && field.find(',') != std::string_view::npos) {
    fail(line, quoted + "has a decimal comma, which is not accepted; must have a decimal point");
  }
  std::string_view digits = field;
  if (digits.front() == '+' && digits.find_first_of("+-", 1) != 1) digits.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = end == digits.data() + digits.size();
  if (whole && error == std::errc::result_out_of_range) fail(line, quoted + "is beyond the range of double");
  if (!whole || error != std::errc()) fail(line, quoted + "is no number; must be one like 1.5 or -2e-3");
  if (!std::isfinite(value)) fail(line, quoted + "must be finite");
  return value;
}

void require_fields(const Line& line, const std::vector<std::string_view>& fields, std::size_t n_columns,
                    const std::string& advice) {
  if (fields.size() == n_columns) return;
  fail(line, "has " + std::to_string(fields.size()) + " value" + (fields.size() == 1 ? "" : "s") + "; must have " +
                 std::to_string(n_columns) + advice);
}

void add_header(CsvColumns& table, const Line& line, const std::vector<std::string_view>& fields,
                std::size_t n_columns) {
  if (!table.line_of_row.empty()) fail(line, "has no numbers; a header must precede the rows");
  if (!table.units.empty()) fail(line, "has no numbers; must be a row, as names and units are given already");
  require_fields(line, fields, n_columns, " names or units, or begin with # to be a comment");
  (table.names.empty() ? table.names : table.units).assign(fields.begin(), fields.end());
}

void add_row(CsvColumns& table, const Line& line, const std::vector<std::string_view>& fields, std::size_t n_columns) {
  if (table.line_of_row.size() == max_rows) fail(line, "is one too many; must be at most a million rows");
  std::vector<double> row;
  row.reserve(fields.size());
  for (const std::string_view field : fields) row.push_back(number(line, field));
  require_fields(line, fields, n_columns, ", with decimal points: decimal commas are not accepted");
  for (std::size_t i = 0; i < n_columns; ++i) table.columns[i].push_back(row[i]);
  table.line_of_row.push_back(line.number);
}

}  // namespace

CsvColumns read_csv(std::istream& stream, const std::string& source_name, std::size_t n_columns) {
  if (n_columns == 0) throw std::invalid_argument(source_name + ": number of columns = 0: must be at least 1");
  if (!stream) throw std::invalid_argument(source_name + ": cannot be read; must be a readable text file");
  CsvColumns table;
  table.columns.resize(n_columns);
  Line line{source_name, 0, {}};
  while (read_line(stream, line)) {
    std::string_view text = line.text;
    if (line.number == 1 && text.substr(0, 3) == "\xEF\xBB\xBF") text.remove_prefix(3);
    text = trimmed(text.substr(0, text.find('#')));
    if (text.empty()) continue;
    const std::vector<std::string_view> fields = split(text);
    const bool after_names = !table.names.empty() && table.units.empty() && table.line_of_row.empty();
    const bool is_header = after_names ? are_units(fields) : !any_number(fields);
    is_header ? add_header(table, line, fields, n_columns) : add_row(table, line, fields, n_columns);
  }
  if (table.line_of_row.empty()) {
    throw std::invalid_argument(source_name + ": has no rows; must have rows of " + std::to_string(n_columns) +
                                " numbers");
  }
  return table;
}

}  // namespace fretval::mdr
