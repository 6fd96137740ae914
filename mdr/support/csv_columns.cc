#include "mdr/support/csv_columns.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "mdr/support/csv_units.h"
#include "mdr/support/trimmed.h"

namespace fretval::mdr {

namespace {

bool is_row(const std::vector<std::string>& fields) {
  return !fields.empty() && std::all_of(fields.begin(), fields.end(), [](const std::string& field) {
    return field.empty() || begins_like_number(field);
  }) && !fields.front().empty();
}

/// A line without what follows a #; of a comment line the text after the #.
struct Content {
  const TextLine* line;
  CsvFields fields;
  bool is_comment;
};

std::optional<Content> content_of(const TextLine& line) {
  const auto mark = line.text.find('#');
  auto text = trimmed(line.text.substr(0, mark));
  const bool is_comment = text.empty() && mark != std::string::npos;
  if (is_comment) text = trimmed(line.text.substr(mark + 1));
  if (text.empty()) return std::nullopt;
  auto fields = split_fields(text);
  while (fields.values.size() > 1 && fields.values.back().empty()) fields.values.pop_back();
  return Content{&line, std::move(fields), is_comment};
}

std::size_t next_content(const std::vector<TextLine>& lines, std::size_t from, std::optional<Content>& content) {
  for (content.reset(); from < lines.size(); ++from)
    if ((content = content_of(lines[from]))) break;
  return from;
}

/// Whether a line can be a row of these columns.
bool has_numbers_at(const Content& content, const Choices& choices) {
  return !content.is_comment && std::all_of(choices.begin(), choices.end(), [&](const auto& choice) {
    return !choice ||
           (choice->column < content.fields.values.size() && begins_like_number(content.fields.values[choice->column]));
  });
}

struct Found {
  Header header;
  Choices choices;
  std::size_t first_row;       ///< place among the lines
  std::size_t n_lines_before;  ///< that are neither names nor units, nor blank
};

/// A line of units has them alone, and knows one at least: names with units in brackets are none.
bool is_line_of_units(const std::vector<std::string>& fields, const std::vector<WantedColumn>& wanted) {
  if (!are_units(fields) || is_row(fields)) return false;
  const auto is_name = [](const std::string& field) {
    const auto bracket = field.find_first_of("[(");
    return bracket != std::string::npos && bracket > 0;
  };
  return std::none_of(fields.begin(), fields.end(), is_name) &&
         std::any_of(fields.begin(), fields.end(),
                     [&](const std::string& field) { return !field.empty() && is_any_unit(unit_text(field), wanted); });
}

/// The table from a line of names and the lines below it; empty: these are no names of the wanted columns. why: what
/// was missing where names first stood above a row without having the columns.
std::optional<Found> header_at(const std::vector<TextLine>& lines, std::size_t at, const Content& names,
                               const std::vector<WantedColumn>& wanted, InOrder in_order, std::string& why) {
  std::optional<Content> next;
  std::size_t place = next_content(lines, at + 1, next);
  if (!next) return std::nullopt;
  std::vector<std::string> units;
  if (is_line_of_units(next->fields.values, wanted)) {
    units = next->fields.values;
    // A blank line of units ends at the last one.
    if (units.size() < names.fields.values.size()) units.resize(names.fields.values.size());
    place = next_content(lines, place + 1, next);
    if (!next) return std::nullopt;
  }
  auto header = header_of(names.fields.values, units, wanted);
  try {
    // A line of units below names that were refused has no units itself.
    auto choices = choices_of(header, wanted, in_order, why.empty());
    const auto n_found =
        std::count_if(choices.begin(), choices.end(), [](const auto& choice) { return choice.has_value(); });
    const auto least = std::min<std::ptrdiff_t>(2, static_cast<std::ptrdiff_t>(wanted.size()));
    if (n_found < least) return std::nullopt;
    if (!has_numbers_at(*next, choices)) {
      if (why.empty() && !next->is_comment)
        why = "line " + std::to_string(next->line->number) + ", \"" + next->line->text.substr(0, 60) +
              "\": is no row of numbers, which must follow the names of the columns";
      return std::nullopt;
    }
    return Found{std::move(header), std::move(choices), place, 0};
  } catch (const NotClear& error) {
    const std::size_t least = 2;
    if (why.empty() && !names.is_comment && names.fields.values.size() >= least && is_row(next->fields.values))
      why = "line " + std::to_string(names.line->number) + ": " + error.what();
  }
  return std::nullopt;
}

std::optional<Found> find_header(const std::vector<TextLine>& lines, const std::vector<WantedColumn>& wanted,
                                 InOrder in_order, std::string& why) {
  std::size_t n_before = 0;
  std::optional<Content> content;
  for (std::size_t at = next_content(lines, 0, content); content; at = next_content(lines, at + 1, content)) {
    if (!is_row(content->fields.values))
      if (auto found = header_at(lines, at, *content, wanted, in_order, why)) {
        found->n_lines_before = n_before;
        return found;
      }
    ++n_before;
  }
  return std::nullopt;
}

std::string skipped_text(const Found& found) {
  std::string text;
  if (found.n_lines_before > 0)
    text = std::to_string(found.n_lines_before) + (found.n_lines_before == 1 ? " line" : " lines") +
           " ahead of the columns";
  std::vector<std::string> others;
  for (std::size_t i = 0; i < found.header.size(); ++i) {
    const bool is_taken = std::any_of(found.choices.begin(), found.choices.end(),
                                      [i](const auto& choice) { return choice && choice->column == i; });
    if (!is_taken) others.push_back(shown(found.header[i]));
  }
  if (!others.empty())
    text += (text.empty() ? "" : ", ") + std::string(others.size() == 1 ? "column " : "columns ") + list_of(others);
  return text;
}

ChosenColumns read_rows(const std::vector<TextLine>& lines, const std::string& source_name, const Found& found) {
  ChosenColumns chosen;
  chosen.skipped = skipped_text(found);
  const auto& choices = found.choices;
  bool any_unit = false;
  for (const auto& choice : choices) {
    chosen.kind.push_back(choice ? std::optional(choice->kind) : std::nullopt);
    chosen.csv.names.push_back(choice ? found.header[choice->column].name : "");
    chosen.csv.units.push_back(choice ? found.header[choice->column].unit : "");
    any_unit |= choice && found.header[choice->column].has_unit;
  }
  if (!any_unit) chosen.csv.units.clear();
  chosen.csv.columns.resize(choices.size());
  NumberReader numbers(source_name);
  for (std::size_t at = found.first_row; at < lines.size(); ++at) {
    const auto content = content_of(lines[at]);
    if (!content || content->is_comment) continue;
    const auto& values = content->fields.values;
    numbers.begin_row(lines[at], content->fields);
    for (std::size_t k = 0; k < choices.size(); ++k) {
      if (!choices[k]) continue;
      const auto column = choices[k]->column;
      if (column >= values.size())
        fail_at(source_name, lines[at],
                "has " + std::to_string(values.size()) + (values.size() == 1 ? " value" : " values") +
                    "; must have one in column " + std::to_string(column + 1) + ", " + shown(found.header[column]));
      chosen.csv.columns[k].push_back(numbers.read(lines[at], values[column]));
    }
    if (values.size() > found.header.size())
      fail_at(source_name, lines[at],
              "has " + std::to_string(values.size()) + " values; must have " + std::to_string(found.header.size()) +
                  ", as many as names");
    chosen.csv.line_of_row.push_back(lines[at].number);
  }
  return chosen;
}

}  // namespace

ChosenColumns read_columns(std::istream& stream, const std::string& source_name,
                           const std::vector<WantedColumn>& wanted, InOrder in_order) {
  const auto lines = read_lines(stream, source_name);
  std::string why;
  if (const auto found = find_header(lines, wanted, in_order, why)) return read_rows(lines, source_name, *found);
  if (!why.empty()) throw std::invalid_argument(source_name + ", " + why);
  ChosenColumns chosen;
  std::size_t n_needed = 0;
  for (const auto& one : wanted) {
    n_needed += !one.is_optional;
    chosen.kind.push_back(one.is_optional ? std::nullopt : std::optional<std::size_t>(0));
  }
  chosen.csv = read_csv(lines, source_name, n_needed);
  return chosen;
}

}  // namespace fretval::mdr
