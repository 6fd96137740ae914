#include "comparison/case_file/json_entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "comparison/case/case.h"
#include "comparison/case_file/entry_lookup.h"

namespace fretval {
namespace {

using nlohmann::json;

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
