#include "comparison/case_file/file_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

#include "comparison/case/case.h"
#include "comparison/case_file/entry_lookup.h"
#include "mdr/support/trimmed.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Words of a name separated by single blanks.
std::string name_in(const std::string& text) {
  std::istringstream words(text);
  std::string name;
  for (std::string word; words >> word;) name += (name.empty() ? "" : " ") + word;
  return name;
}

class Lines {
 public:
  Lines(fs::path file, Problems& problems) : file_(std::move(file)), problems_(problems) {}

  PrmFile read(const std::string& text) {
    std::istringstream stream(text);
    std::string logical;  // a line that ends in a backslash goes on in the next
    for (std::string line; std::getline(stream, line);) {
      ++n_read_;
      logical += trimmed(line.substr(0, line.find('#')));
      if (!logical.empty() && logical.back() == '\\') {
        logical.pop_back();
        continue;
      }
      if (!logical.empty()) take(logical);
      logical.clear();
    }
    if (!logical.empty()) take(logical);
    if (is_open_) misread(fmt::format("subsection {} of line {} has no end", section_, line_of_section_));
    return result_;
  }

 private:
  [[nodiscard]] std::string here(const std::string& problem) const {
    return fmt::format("{}: line {}: {}", file_.string(), n_read_, problem);
  }
  [[noreturn]] void fail(const std::string& problem) const { throw InputError(here(problem)); }
  /// What is missing may be what was meant here.
  void misread(const std::string& problem) {
    problems_.add(here(problem));
    problems_.has_unread_lines = true;
  }

  void take(const std::string& line) {
    std::istringstream words(line);
    std::string word, rest;
    words >> word;
    std::getline(words, rest);
    rest = trimmed(rest);
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (word == "include") return include(rest);
    if (word == "subsection" && !rest.empty()) return begin_section(name_in(rest));
    if (word == "end" && rest.empty()) return end_section();
    const auto equals = rest.find('=');
    if (word == "set" && equals != std::string::npos)
      return set(name_in(rest.substr(0, equals)), trimmed(rest.substr(equals + 1)));
    misread(fmt::format("{}: expected set ENTRY = VALUE, subsection NAME, end or include FILE", line.substr(0, 200)));
  }

  void include(const std::string& name) {
    if (name.empty()) fail("the include line names no file");
    if (line_of_section_ > 0) fail(fmt::format("include {} must stand before the first subsection", name));
    result_.included.push_back(file_.parent_path() / name);
    std::error_code error;
    if (!fs::exists(result_.included.back(), error))
      fail(fmt::format("include {}: no such file as {}", name, result_.included.back().string()));
  }

  void begin_section(const std::string& name) {
    if (is_open_)
      misread(fmt::format("subsection {} stands within subsection {} of line {}, which has no end before it", name,
                          section_, line_of_section_));
    is_open_ = true;
    section_ = name;
    line_of_section_ = n_read_;
    if (!find_section(name)) problems_.add(here(no_such_section(name, problems_)));
  }

  void end_section() {
    if (!is_open_) misread("end: there is no subsection that it could end");
    is_open_ = false;
  }

  void set(const std::string& name, const std::string& value) {
    if (!is_open_) return misread(fmt::format("set {}: every entry stands within a subsection", name));
    if (!find_section(section_)) return;  // has been said
    const std::string full = fmt::format("{} / {}", section_, name);
    const auto [first, is_new] = line_of_entry_.emplace(full, n_read_);
    if (!is_new)
      problems_.add(
          here(fmt::format("{} is set a second time, first in line {}; must be set once", full, first->second)));
    else if (is_entry(section_, name))
      result_.entries.set(section_, name, value);
    else
      problems_.add(here(no_such_entry(section_, name, problems_)));
  }

  fs::path file_;
  Problems& problems_;
  PrmFile result_;
  int n_read_ = 0;
  bool is_open_ = false;  ///< a section
  std::string section_;
  int line_of_section_ = 0;  ///< where the last one began
  std::map<std::string, int> line_of_entry_;
};

json parse_unique_keys(const std::string& text, const std::filesystem::path& file) {
  std::vector<std::set<std::string>> keys;  // by depth, to refuse a key that comes twice
  std::string current;
  const auto check = [&](int depth, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event != json::parse_event_t::key) return true;
    const auto key = value.get<std::string>();
    if (depth == 1) current = key;
    if (!keys.back().insert(key).second)
      throw InputError(fmt::format("{}: {}{} is there a second time; must be there once", file.string(),
                                   depth == 1 ? "" : current + " / ", key));
    return true;
  };
  try {
    return json::parse(text, check);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::optional<std::string> text_of_value(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number() || value.is_boolean()) return value.dump();
  return std::nullopt;
}

/// The value as text of a .prm file; empty if it has no place there.
std::optional<std::string> text_of_entry(const json& value) {
  if (!value.is_array()) return text_of_value(value);
  std::vector<std::string> parts;
  for (const auto& part : value) {
    const auto text = text_of_value(part);
    if (!text) return std::nullopt;
    parts.push_back(*text);
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace

PrmFile read_prm(const std::string& text, const fs::path& file, Problems& problems) {
  return Lines(file, problems).read(text);
}

void parse_json_entries(const std::string& text, const std::filesystem::path& file, EntryTexts& entries,
                        Problems& problems) {
  const auto sections = parse_unique_keys(text, file);
  if (!sections.is_object()) throw InputError(fmt::format("{}: must be a JSON object of sections", file.string()));
  for (const auto& [section, members] : sections.items()) {
    if (!members.is_object())
      throw InputError(fmt::format("{}: {}: must be a JSON object of entries", file.string(), section));
    if (!find_section(section)) {
      problems.add(fmt::format("{}: {}", file.string(), no_such_section(section, problems)));
      continue;
    }
    for (const auto& [name, value] : members.items()) {
      const auto entry = text_of_entry(value);
      if (!is_entry(section, name)) {
        problems.add(fmt::format("{}: {}", file.string(), no_such_entry(section, name, problems)));
      } else if (!entry) {
        problems.add(fmt::format("{}: {} / {}: must be text, a number, true or false, or an array of them",
                                 file.string(), section, name));
        problems.meant.insert(section + " / " + name);
      } else {
        entries.set(section, name, *entry);
      }
    }
  }
}

}  // namespace fretval
