#include "comparison/case_file/entry_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "comparison/case_file/entry_lookup.h"
#include "comparison/support/closest.h"
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

/// Empty if one of them is not valid. dimensions: in turn.
std::vector<double> read_list(std::vector<std::string> parts, const std::vector<Dimension>& dimensions,
                              const ValidNumber& valid) {
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
    if (!measure || !valid.accepts(measure->value)) return {};
    values.push_back(measure->value);
  }
  return values;
}

std::vector<Dimension> dimensions_of(const std::string& section, const std::string& name) {
  const auto* entry = find_entry(section, name);
  return entry && !entry->dimensions.empty() ? entry->dimensions : std::vector{Dimension::number};
}

}  // namespace

const ValidNumber any_number{[](double) { return true; }, "a finite number"};
const ValidNumber positive_number{[](double x) { return x > 0; }, "a positive number"};
const ValidNumber not_negative_number{[](double x) { return x >= 0; }, "a number that is not negative"};

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

std::string EntryReader::one_of(const std::string& section, const std::string& name,
                                const std::vector<std::string>& choices) const {
  std::string value = text(section, name);
  if (std::find(choices.begin(), choices.end(), value) != choices.end()) return value;
  fail(section, name, fmt::format("one of {}{}", fmt::join(choices, ", "), did_you_mean(value, choices)));
  return "";
}

double EntryReader::number(const std::string& section, const std::string& name, const ValidNumber& valid) const {
  const auto value = text(section, name);
  const auto dimension = dimensions_of(section, name).front();
  const auto measure = read_measure(value, dimension);
  if (measure && valid.accepts(measure->value)) return measure->value;
  fail(section, name, with_units(valid.description, dimension, value));
  return std::nan("");
}

unsigned EntryReader::whole(const std::string& section, const std::string& name, const ValidNumber& valid) const {
  const double value = number(section, name, valid);
  return std::isnan(value) ? 0 : static_cast<unsigned>(value);
}

std::vector<double> EntryReader::numbers(const std::string& section, const std::string& name,
                                         const ValidNumber& valid) const {
  const auto dimensions = dimensions_of(section, name);
  const auto parts = split_at(',', text(section, name));
  auto values = read_list(parts, dimensions, valid);
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
  return read_list(split_at(separator, text), {dimensions_of(section, name).front()}, any_number);
}

std::string EntryReader::units_of(const std::string& section, const std::string& name) const {
  return valid_units(dimensions_of(section, name).front());
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
