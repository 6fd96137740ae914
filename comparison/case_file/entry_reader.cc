#include "comparison/case_file/entry_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "comparison/support/text.h"
#include "mdr/support/trimmed.h"

namespace fretval {
namespace {

/// A value as an error shows it.
std::string shown(const std::string& text) {
  return text.size() > 200 ? text.substr(0, 200) + "..." : text;
}

/// "a positive number, in m, cm, ...; in m without a unit"; of a pure number only where something follows it.
std::string with_units(const char* description, Dimension dimension, const std::string& text) {
  const bool has_more = !text.empty() && read_measure(text, dimension) == std::nullopt;
  if (dimension == Dimension::number && !has_more) return description;
  return fmt::format("{}, {}", description, valid_units(dimension));
}

std::vector<std::string> split_at(char separator, std::string rest) {
  std::vector<std::string> parts;
  for (;;) {
    const auto end = rest.find(separator);
    parts.push_back(trimmed(rest.substr(0, end)));
    if (end == std::string::npos) return parts;
    rest = rest.substr(end + 1);
  }
}

/// The numbers of a list; empty if one of them is not valid. dimensions: of the numbers in turn.
std::vector<double> read_list(std::vector<std::string> parts, const std::vector<Dimension>& dimensions,
                              bool (*accepts)(double)) {
  const auto dimension = [&](std::size_t i) { return dimensions[i % dimensions.size()]; };
  std::vector<std::optional<Measure>> measures;
  const auto read = [&] {
    measures.clear();
    for (std::size_t i = 0; i < parts.size(); ++i) measures.push_back(read_measure(parts[i], dimension(i)));
  };
  const auto n_units = [&] {
    return std::count_if(measures.begin(), measures.end(), [](const auto& m) { return m && m->has_unit; });
  };
  read();
  if (dimensions.size() == 1 && n_units() == 1 && measures.back() && measures.back()->has_unit) {
    const auto unit = parts.back().substr(parts.back().find_first_not_of("+-.0123456789eE"));
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) parts[i] += unit;
    read();
  }
  const auto n_measures = static_cast<std::ptrdiff_t>(measures.size());
  if (n_units() != 0 && n_units() != n_measures) return {};
  std::vector<double> values;
  for (const auto& measure : measures) {
    if (!measure || !accepts(measure->value)) return {};
    values.push_back(measure->value);
  }
  return values;
}

Dimension dimension_of(const std::string& section, const std::string& name) {
  const auto& dimensions = find_entry(section, name)->dimensions;
  return dimensions.empty() ? Dimension::number : dimensions.front();
}

}  // namespace

std::string EntryReader::text(const std::string& section, const std::string& name) const {
  return entries_.text(section, name);
}

bool EntryReader::given(const std::string& section, const std::string& name) const {
  return !text(section, name).empty();
}

void EntryReader::fail(const std::string& section, const std::string& name, const std::string& valid) const {
  const std::string value = text(section, name);
  if (!value.empty())
    problems_.add(fmt::format("{}: {} / {} = {}: expected {}", file_, section, name, shown(value), valid));
  else if (!problems_.has_unread_lines && problems_.meant.count(section) == 0 &&
           problems_.meant.count(section + " / " + name) == 0)
    problems_.add(fmt::format("{}: {} / {} is missing; expected {}", file_, section, name, valid));
}

void EntryReader::forbid(const std::string& section, const std::string& name, const std::string& reason) const {
  if (given(section, name))
    problems_.add(fmt::format("{}: {} / {} = {} has no meaning here: {}", file_, section, name,
                              shown(text(section, name)), reason));
}

std::string EntryReader::word(const std::string& section, const std::string& name) const {
  const auto position = position_of_word(section, name);
  return position ? find_entry(section, name)->values.words[*position] : "";
}

std::optional<std::size_t> EntryReader::position_of_word(const std::string& section, const std::string& name) const {
  const auto& words = find_entry(section, name)->values.words;
  const auto value = text(section, name);
  const auto found = std::find(words.begin(), words.end(), value);
  if (found != words.end()) return found - words.begin();
  fail(section, name, fmt::format("one of {}{}", fmt::join(words, ", "), did_you_mean(value, words)));
  return std::nullopt;
}

bool EntryReader::says(const std::string& section, const std::string& name, const std::string& expected) const {
  return given(section, name) && word(section, name) == expected;
}

void EntryReader::forbid_others(const std::string& section, const std::string& owner) const {
  const auto& entries = find_section(section)->entries;
  for (const auto& entry : entries)
    if (!entry.belongs_to(owner))
      forbid(section, entry.name,
             fmt::format("it belongs to {} = {}, not to {}", entries.front().name, fmt::join(entry.owners, " or "),
                         owner));
}

double EntryReader::number(const std::string& section, const std::string& name) const {
  const auto value = text(section, name);
  const auto& entry = *find_entry(section, name);
  const auto& valid = entry.values.number.value();
  const auto measure = read_measure(value, entry.dimensions.front());
  if (measure && valid.accepts(measure->value)) return measure->value;
  fail(section, name, with_units(valid.description, entry.dimensions.front(), value));
  return std::nan("");
}

unsigned EntryReader::whole(const std::string& section, const std::string& name) const {
  const double value = number(section, name);
  return std::isnan(value) ? 0 : static_cast<unsigned>(value);
}

std::vector<double> EntryReader::numbers(const std::string& section, const std::string& name) const {
  const auto& entry = *find_entry(section, name);
  const auto& dimensions = entry.dimensions;
  const auto& valid = entry.values.number.value();
  const auto parts = split_at(',', text(section, name));
  auto values = read_list(parts, dimensions, valid.accepts);
  if (!values.empty()) return values;
  if (parts.size() > 1 && parts.back().empty()) {
    fail(section, name, "a number after the last comma");
    return {};
  }
  std::string expected = fmt::format("a list separated by commas, each {}", valid.description);
  std::string units;
  for (const auto dimension : dimensions) units += (units.empty() ? ", " : " | ") + valid_units(dimension);
  if (dimensions.front() != Dimension::number) expected += units;
  fail(section, name, expected + "; a unit for each of them, for none, or for the last one and so for all");
  return {};
}

std::vector<double> EntryReader::numbers_for(const std::string& section, const std::string& name,
                                             const std::string& text, char separator) const {
  const auto any = [](double) { return true; };
  return read_list(split_at(separator, text), {dimension_of(section, name)}, any);
}

std::string EntryReader::units_of(const std::string& section, const std::string& name) const {
  return valid_units(dimension_of(section, name));
}

std::string EntryReader::path(const std::string& section, const std::string& name) const {
  const std::string value = text(section, name);
  const auto file = std::filesystem::path(file_).parent_path() / value;
  std::error_code error;
  if (!value.empty() && std::filesystem::is_regular_file(file, error)) return file.string();
  fail(section, name, "the name of a file, relative to the case file");
  return "";
}

}  // namespace fretval
