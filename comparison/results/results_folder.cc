#include "comparison/results/results_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "comparison/case/case.h"
#include "comparison/support/json.h"
#include "comparison/support/parallel.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

using nlohmann::ordered_json;

/// What a value of a result has to be.
struct Kind {
  bool (*is)(const ordered_json& value);
  const char* words;
};
constexpr double most_of_anything = 2e9;  // which the report takes as an integer
const Kind text{[](const ordered_json& v) { return v.is_string(); }, "text"};
const Kind yes_or_no{[](const ordered_json& v) { return v.is_boolean(); }, "true or false"};
const Kind object{[](const ordered_json& v) { return v.is_object(); }, "an object"};
const Kind number{[](const ordered_json& v) { return v.is_number(); }, "a number"};
const Kind number_or_null{[](const ordered_json& v) { return v.is_number() || v.is_null(); }, "a number or null"};
const Kind count{[](const ordered_json& v) { return v.is_number() && std::abs(v.get<double>()) <= most_of_anything; },
                 "a number of at most 2e9"};

/// A place in a result that the report reads; *: every key of an object. Its parts are those of the places before it.
struct Place {
  std::string path;
  Kind kind;
  bool may_lack = false;
};
/// Results without it were written before there were versions.
const Kind known_schema{[](const ordered_json& v) { return v == 1 || v == result_schema; },
                        "1 or 2, the versions that are known here"};
const Kind text_or_null{[](const ordered_json& v) { return v.is_string() || v.is_null(); }, "text or null"};
const Kind a_list{[](const ordered_json& v) { return v.is_array(); }, "a list"};
const Kind filled_list{[](const ordered_json& v) { return v.is_array() && !v.empty(); }, "a list that is not empty"};
const Kind annuli_or_region{[](const ordered_json& v) { return v.is_array() || v.is_object(); },
                            "a list of annuli or a region"};
const std::vector<Place> places{{"schema", known_schema, true},
                                {"name", text},
                                {"pass", yes_or_no},
                                {"verdict", text, true},
                                {"proof", text, true},
                                {"scene", object},
                                {"scene/shape", text, true},
                                {"scene/rheology", text, true},
                                {"scene/sweep", object, true},
                                {"scene/sweep/family", text},
                                {"scene/sweep/entry", text},
                                {"scene/sweep/value", number},
                                {"scene/sweep/second_entry", text, true},
                                {"scene/sweep/second_value", number, true},
                                {"mdr", object},
                                {"fe", object},
                                {"fe/error_estimate", object, true},
                                {"fe/error_estimate/*/shares", object, true},
                                {"fe/error_estimate/*/shares/*", object},
                                {"not_compared", object, true},
                                {"not_compared/image_falls", a_list},
                                {"not_compared/at_rest", object},
                                {"not_compared/at_rest/*", number},
                                {"fe/wear", object, true},
                                {"fe/wear/cycles", filled_list},
                                {"fe/wear/volume", filled_list},
                                {"fe/surface_wear", object, true},
                                {"fe/surface_wear/cycles", filled_list},
                                {"fe/surface_wear/volume", filled_list},
                                {"fe/zones", object, true},
                                {"fe/zones/contact", annuli_or_region},
                                {"comparison", object},
                                {"comparison/*", object},
                                {"comparison/*/pass", yes_or_no},
                                {"comparison/*/tolerance", number},
                                {"comparison/*/verdict", text_or_null, true},
                                {"comparison/*/asked", yes_or_no, true},
                                {"comparison/*/mdr_error", number, true},
                                {"comparison/*/difference", number_or_null},
                                {"comparison/*/error_bar", number_or_null, true},
                                {"cost", object},
                                {"cost/seconds", object},
                                {"cost/seconds/*", number},
                                {"cost/dofs", count},
                                {"cost/time_steps", count, true},
                                {"cost/cycles", count, true},
                                {"cost/computations", count, true},
                                {"cost/peak_memory_bytes", number, true}};

std::string shown(const ordered_json& value) {
  const bool long_text = value.is_string() && value.get_ref<const std::string&>().size() > 60;
  return value.is_primitive() && !long_text ? value.dump() : value.type_name();
}

/// Throws unless what is at the rest of a path, from a value on, is of its kind. before: the path of the value.
void require(const fs::path& file, const Place& place, const ordered_json& value, const std::string& before,
             const std::string& rest) {
  const auto slash = rest.find('/');
  const std::string key = rest.substr(0, slash), after = slash == std::string::npos ? "" : rest.substr(slash + 1);
  if (rest.empty()) {
    if (!place.kind.is(value))
      throw InputError(fmt::format("{}: the key \"{}\" is {}, must be {}; is this a result of fretval?", file.string(),
                                   before, shown(value), place.kind.words));
  } else if (value.is_object()) {
    const auto path = [&](const std::string& name) { return before + (before.empty() ? "" : "/") + name; };
    if (key == "*")
      for (const auto& [name, part] : value.items()) require(file, place, part, path(name), after);
    else if (value.contains(key))
      require(file, place, value[key], path(key), after);
    else if (after.empty() && !place.may_lack)
      throw InputError(
          fmt::format("{}: the key \"{}\" is missing; is this a result of fretval?", file.string(), path(key)));
  }
}

StoredResult read_result(const fs::path& file) {
  std::ifstream stream(file);
  try {
    StoredResult result{ordered_json::parse(stream), file.parent_path()};
    if (!result.json.is_object())
      throw InputError(fmt::format("{}: is no JSON object, must be a result", file.string()));
    for (const auto& place : places) require(file, place, result.json, "", place.path);
    return result;
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

}  // namespace

double StoredResult::number(const char* section, const char* key) const {
  return number_or_nan(json.at(section), key);
}

std::string StoredResult::text(const char* section, const char* key) const {
  return json.at(section).value(key, std::string());
}

const ordered_json& StoredResult::sweep() const {
  static const auto none = ordered_json::object();
  const auto& scene = json.at("scene");
  const auto found = scene.find("sweep");
  return found == scene.end() ? none : *found;
}

bool StoredResult::has_one_frequency() const {
  const auto& scene = json.at("scene");
  return !scene.contains("normal_harmonics") && !scene.contains("tangential_harmonics") &&
         !(scene.contains("tangential_frequency") && scene.at("tangential_frequency") != scene.at("frequency"));
}

bool StoredResult::has_forces() const {
  const auto& scene = json.at("scene");
  return scene.contains("normal_force_mean") || scene.contains("tangential_force_amplitude");
}

bool StoredResult::has_period() const {
  return json.at("scene").value("has_period", true);  // which older results do not have
}

const char* StoredResult::cycle_name() const {
  if (is_pass(motion_kind())) return "pass";
  return has_period() ? "period" : "near cycle";
}

std::vector<StoredResult> read_results(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(fmt::format("{}: no such folder; expected one that fretval run has written", folder.string()));
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "result.json") files.push_back(entry.path());
  std::vector<StoredResult> results(files.size());
  for_each_in_parallel(files.size(), [&](std::size_t i) { results[i] = read_result(files[i]); });
  std::sort(results.begin(), results.end(), [](const StoredResult& a, const StoredResult& b) {
    return std::make_tuple(a.family(), a.sweep_value(), a.second_value()) <
           std::make_tuple(b.family(), b.sweep_value(), b.second_value());
  });
  return results;
}

ordered_json section_of(const fs::path& file, ordered_json (*section)(const ordered_json&)) {
  if (!fs::exists(file)) return nullptr;
  std::ifstream stream(file);
  try {
    return section(ordered_json::parse(stream));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<std::string> column_names(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  return std::getline(stream, line) ? split(line) : std::vector<std::string>{};
}

std::pair<std::vector<double>, std::vector<double>> read_columns(const fs::path& file, const std::string& x,
                                                                 const std::string& y) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  const auto names = split(line);
  const auto ix = std::find(names.begin(), names.end(), x) - names.begin();
  const auto iy = std::find(names.begin(), names.end(), y) - names.begin();
  std::pair<std::vector<double>, std::vector<double>> columns;
  while (std::getline(stream, line)) {
    const auto words = split(line);
    if (std::max(ix, iy) >= static_cast<std::ptrdiff_t>(words.size())) return {};
    columns.first.push_back(std::strtod(words[static_cast<std::size_t>(ix)].c_str(), nullptr));
    columns.second.push_back(std::strtod(words[static_cast<std::size_t>(iy)].c_str(), nullptr));
  }
  return columns;
}

}  // namespace fretval
