#include "comparison/case/entry_reader.h"

#include <deal.II/base/parameter_handler.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>

#include "comparison/case/trimmed.h"

namespace fretval {
namespace {

double parse_number(const std::string& text, bool& ok) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  ok = error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
  return value;
}

/// A value as an error shows it.
std::string shown(const std::string& text) {
  return text.size() > 200 ? text.substr(0, 200) + "..." : text;
}

}  // namespace

const ValidNumber any_number{[](double) { return true; }, "a finite number"};
const ValidNumber positive_number{[](double x) { return x > 0; }, "a positive number"};
const ValidNumber not_negative_number{[](double x) { return x >= 0; }, "a number that is not negative"};

std::string EntryReader::text(const std::string& section, const std::string& name) const {
  handler_.enter_subsection(section);
  std::string value = handler_.get(name);
  handler_.leave_subsection();
  return value;
}

bool EntryReader::given(const std::string& section, const std::string& name) const {
  return !text(section, name).empty();
}

void EntryReader::fail(const std::string& section, const std::string& name, const std::string& valid) const {
  const std::string value = text(section, name);
  if (value.empty()) throw InputError(fmt::format("{}: {} / {} is missing; expected {}", file_, section, name, valid));
  throw InputError(fmt::format("{}: {} / {} = {}: expected {}", file_, section, name, shown(value), valid));
}

void EntryReader::forbid(const std::string& section, const std::string& name, const std::string& reason) const {
  if (given(section, name))
    throw InputError(fmt::format("{}: {} / {} = {} has no meaning here: {}", file_, section, name,
                                 shown(text(section, name)), reason));
}

std::string EntryReader::one_of(const std::string& section, const std::string& name,
                                const std::vector<std::string>& choices) const {
  std::string value = text(section, name);
  if (std::find(choices.begin(), choices.end(), value) == choices.end())
    fail(section, name, fmt::format("one of {}", fmt::join(choices, ", ")));
  return value;
}

double EntryReader::number(const std::string& section, const std::string& name, const ValidNumber& valid) const {
  bool ok = false;
  const double value = parse_number(text(section, name), ok);
  if (!ok || !valid.accepts(value)) fail(section, name, valid.description);
  return value;
}

std::vector<double> EntryReader::numbers(const std::string& section, const std::string& name,
                                         const ValidNumber& valid) const {
  std::vector<double> values;
  std::string rest = text(section, name);
  if (rest.empty()) fail(section, name, fmt::format("a list, each {}", valid.description));
  while (!rest.empty()) {
    const auto comma = rest.find(',');
    bool ok = false;
    values.push_back(parse_number(trimmed(rest.substr(0, comma)), ok));
    if (!ok || !valid.accepts(values.back()))
      fail(section, name, fmt::format("a list separated by commas, each {}", valid.description));
    if (comma == std::string::npos) break;
    rest = rest.substr(comma + 1);
    if (trimmed(rest).empty()) fail(section, name, "a number after the last comma");
  }
  return values;
}

std::string EntryReader::path(const std::string& section, const std::string& name) const {
  const std::string value = text(section, name);
  const auto file = std::filesystem::path(file_).parent_path() / value;
  std::error_code error;
  if (value.empty() || !std::filesystem::is_regular_file(file, error))
    fail(section, name, "the name of a file, relative to the case file");
  return file.string();
}

}  // namespace fretval
