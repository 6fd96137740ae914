#include "mdr/support/csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <system_error>

#include "mdr/support/trimmed.h"

namespace fretval::mdr {

namespace {

constexpr std::size_t max_rows = 1'000'000;
constexpr std::string_view blanks = " \t";

std::string unquoted(std::string_view text) {
  const auto field = trimmed(text);
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
    return trimmed(std::string_view(field).substr(1, field.size() - 2));
  return field;
}

/// A separator between quotation marks is none, if the quotation begins a field: G" has one of its own.
std::vector<std::string> split_at(std::string_view text, char separator) {
  std::vector<std::string> fields;
  for (std::size_t begin = 0;;) {
    std::size_t from = text.find_first_not_of(blanks, begin);
    if (from != std::string_view::npos && text[from] == '"') from = text.find('"', from + 1);
    const std::size_t end = text.find(separator, from == std::string_view::npos ? begin : std::max(from, begin));
    fields.push_back(unquoted(text.substr(begin, end - begin)));
    if (end == std::string_view::npos) return fields;
    begin = end + 1;
  }
}

/// A unit in brackets belongs to the word before it.
std::vector<std::string> split_at_blanks(std::string_view text) {
  std::vector<std::string> fields;
  std::size_t end;
  for (std::size_t begin = text.find_first_not_of(blanks); begin < text.size();
       begin = text.find_first_not_of(blanks, end)) {
    end = std::min(text.find_first_of(blanks, begin), text.size());
    const auto field = text.substr(begin, end - begin);
    if (!fields.empty() && (field.front() == '[' || field.front() == '('))
      fields.back() += " " + std::string(field);
    else
      fields.push_back(unquoted(field));
  }
  return fields;
}

bool any_number(const std::vector<std::string>& fields) {
  return std::any_of(fields.begin(), fields.end(), begins_like_number);
}

bool has_blanks_in_numbers(const std::vector<std::string>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](const std::string& field) {
    return begins_like_number(field) && field.find_first_of(blanks) != std::string::npos;
  });
}

bool has_commas_at_ends(const std::vector<std::string>& fields) {
  return std::any_of(fields.begin(), fields.end(), [](const std::string& field) {
    return !field.empty() && (field.front() == ',' || field.back() == ',');
  });
}

const char* name_of(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case ',':
      return "commas";
    case '\t':
      return "tabs";
    default:
      return "blanks";
  }
}

void require_fields(const std::string& source, const TextLine& line, const std::vector<std::string>& fields,
                    std::size_t n_columns, const std::string& advice) {
  if (fields.size() == n_columns) return;
  fail_at(source, line,
          "has " + std::to_string(fields.size()) + " value" + (fields.size() == 1 ? "" : "s") + "; must have " +
              std::to_string(n_columns) + advice);
}

void add_header(CsvColumns& table, const std::string& source, const TextLine& line,
                const std::vector<std::string>& fields, std::size_t n_columns) {
  if (!table.line_of_row.empty()) fail_at(source, line, "has no numbers; a header must precede the rows");
  if (!table.units.empty())
    fail_at(source, line, "has no numbers; must be a row, as names and units are given already");
  require_fields(source, line, fields, n_columns, " names or units, or begin with # to be a comment");
  (table.names.empty() ? table.names : table.units).assign(fields.begin(), fields.end());
}

void add_row(CsvColumns& table, const std::string& source, const TextLine& line, const CsvFields& fields,
             std::size_t n_columns, NumberReader& numbers) {
  if (table.line_of_row.size() == max_rows) fail_at(source, line, "is one too many; must be at most a million rows");
  numbers.begin_row(line, fields);
  std::vector<double> row;
  row.reserve(fields.values.size());
  for (const auto& field : fields.values) row.push_back(numbers.read(line, field));
  require_fields(source, line, fields.values, n_columns,
                 ", with decimal points: decimal commas are not accepted but between semicolons or tabs");
  for (std::size_t i = 0; i < n_columns; ++i) table.columns[i].push_back(row[i]);
  table.line_of_row.push_back(line.number);
}

}  // namespace

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

bool are_units(const std::vector<std::string>& fields) {
  const auto n_ratios = std::count(fields.begin(), fields.end(), "1");
  return n_ratios < static_cast<std::ptrdiff_t>(fields.size()) &&
         n_ratios == std::count_if(fields.begin(), fields.end(), begins_like_number);
}

// A comma next to a blank, or without any blank in the line, separates; what "1,5 2,5" means is not clear.
CsvFields split_fields(std::string_view line) {
  const auto text = trimmed(line);
  if (text.find(';') != std::string::npos) return {split_at(text, ';'), ';'};
  if (text.find('\t') != std::string::npos) {
    auto by_tab = split_at(text, '\t');
    if (!has_blanks_in_numbers(by_tab) && !has_commas_at_ends(by_tab)) return {std::move(by_tab), '\t'};
  }
  if (text.find(',') == std::string::npos) return {split_at_blanks(text), ' '};
  auto by_comma = split_at(text, ',');
  const bool one_value_each = std::none_of(by_comma.begin(), by_comma.end(), [](const std::string& field) {
    return field.find_first_of(blanks) != std::string::npos;
  });
  if (one_value_each || !any_number(by_comma) || !has_blanks_in_numbers(by_comma)) return {std::move(by_comma), ','};
  return {split_at_blanks(text), ' '};
}

void NumberReader::begin_row(const TextLine& line, const CsvFields& fields) {
  separator_ = fields.separator;
  if (fields.values.size() < 2) return;
  const auto is_blank = [](char separator) { return separator == ' ' || separator == '\t'; };
  if (before_ && *before_ != separator_ && !(is_blank(*before_) && is_blank(separator_)))
    fail_at(source_name_, line,
            std::string("has ") + name_of(separator_) + " between its values, rows before have " + name_of(*before_) +
                "; must be the same in all of the file");
  before_ = separator_;
}

double NumberReader::read(const TextLine& line, const std::string& field) {
  const auto fail = [&](const std::string& problem) { fail_at(source_name_, line, problem); };
  const std::string quoted = "\"" + field.substr(0, 30) + "\" ";
  if (field.empty()) fail("has an empty value; must be a number");
  std::string digits = field;
  const auto comma = digits.find(',');
  if (comma != std::string::npos && begins_like_number(field)) {
    if (separator_ != ';' && separator_ != '\t')
      fail(quoted +
           "has a decimal comma, which is not accepted but between semicolons or tabs; must have a decimal point");
    if (digits.find('.') != std::string::npos || digits.find(',', comma + 1) != std::string::npos)
      fail(quoted + "has more than one decimal mark; must have no marks of thousands");
    digits[comma] = '.';
    any_comma_ = true;
  } else if (digits.find('.') != std::string::npos && begins_like_number(field)) {
    any_point_ = true;
  }
  if (any_comma_ && any_point_)
    fail(quoted + "has another decimal mark than values before; must be the same in all of the file");
  if (digits.front() == '+' && digits.find_first_of("+-", 1) != 1) digits.erase(0, 1);
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool whole = end == digits.data() + digits.size();
  if (whole && error == std::errc::result_out_of_range) fail(quoted + "is beyond the range of double");
  if (!whole || error != std::errc()) fail(quoted + "is no number; must be one like 1.5 or -2e-3");
  if (!std::isfinite(value)) fail(quoted + "must be finite");
  return value;
}

CsvColumns read_csv(const std::vector<TextLine>& lines, const std::string& source_name, std::size_t n_columns) {
  if (n_columns == 0) throw std::invalid_argument(source_name + ": number of columns = 0: must be at least 1");
  CsvColumns table;
  table.columns.resize(n_columns);
  NumberReader numbers(source_name);
  for (const auto& line : lines) {
    const auto text = trimmed(line.text.substr(0, line.text.find('#')));
    if (text.empty()) continue;
    const auto fields = split_fields(text);
    const bool after_names = !table.names.empty() && table.units.empty() && table.line_of_row.empty();
    const bool is_header = after_names ? are_units(fields.values) : !any_number(fields.values);
    if (is_header)
      add_header(table, source_name, line, fields.values, n_columns);
    else
      add_row(table, source_name, line, fields, n_columns, numbers);
  }
  if (table.line_of_row.empty()) {
    throw std::invalid_argument(source_name + ": has no rows; must have rows of " + std::to_string(n_columns) +
                                " numbers");
  }
  return table;
}

CsvColumns read_csv(std::istream& stream, const std::string& source_name, std::size_t n_columns) {
  if (n_columns == 0) throw std::invalid_argument(source_name + ": number of columns = 0: must be at least 1");
  return read_csv(read_lines(stream, source_name), source_name, n_columns);
}

}  // namespace fretval::mdr
