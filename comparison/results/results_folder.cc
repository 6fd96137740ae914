#include "comparison/results/results_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "comparison/case/case.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

using nlohmann::ordered_json;

[[noreturn]] void fail(const fs::path& file, const std::string& key, const ordered_json& value, const char* valid) {
  const bool short_value =
      value.is_primitive() && !(value.is_string() && value.get_ref<const std::string&>().size() > 60);
  throw InputError(fmt::format("{}: the key \"{}\" is {}, must be {}; is this a result of fretval?", file.string(), key,
                               short_value ? value.dump() : value.type_name(), valid));
}

constexpr double most_of_anything = 2e9;

using Kind = bool (ordered_json::*)() const noexcept;

/// Throws unless a key of an object is of one kind; may_lack: or not there.
void require(const fs::path& file, const ordered_json& object, const std::string& path, const char* key, Kind kind,
             const char* valid, bool may_lack = false) {
  const std::string full = path + key;
  if (!object.contains(key)) {
    if (may_lack) return;
    throw InputError(fmt::format("{}: the key \"{}\" is missing; is this a result of fretval?", file.string(), full));
  }
  if (!(object.at(key).*kind)()) fail(file, full, object.at(key), valid);
}

void require_number_or_null(const fs::path& file, const ordered_json& object, const std::string& path,
                            const char* key) {
  if (object.contains(key) && !object.at(key).is_null())
    require(file, object, path, key, &ordered_json::is_number, "a number or null");
}

void require_objects_in(const fs::path& file, const ordered_json& object, const std::string& path) {
  for (const auto& [key, part] : object.items())
    if (!part.is_object()) fail(file, path + key, part, "an object");
}

void require_scene(const fs::path& file, const ordered_json& scene) {
  for (const char* key : {"shape", "rheology"})
    require(file, scene, "scene/", key, &ordered_json::is_string, "text", true);
  require(file, scene, "scene/", "sweep", &ordered_json::is_object, "an object", true);
  if (!scene.contains("sweep")) return;
  for (const char* key : {"family", "entry"})
    require(file, scene["sweep"], "scene/sweep/", key, &ordered_json::is_string, "text");
  require(file, scene["sweep"], "scene/sweep/", "value", &ordered_json::is_number, "a number");
}

void require_comparison(const fs::path& file, const ordered_json& comparison) {
  require_objects_in(file, comparison, "comparison/");
  for (const auto& [key, one] : comparison.items()) {
    const std::string path = "comparison/" + key + "/";
    require(file, one, path, "pass", &ordered_json::is_boolean, "true or false");
    require(file, one, path, "tolerance", &ordered_json::is_number, "a number");
    require(file, one, path, "verdict", &ordered_json::is_string, "text", true);
    if (!one.contains("difference")) fail(file, path + "difference", nullptr, "there");
    for (const char* number : {"difference", "error_bar"}) require_number_or_null(file, one, path, number);
  }
}

void require_cost(const fs::path& file, const ordered_json& cost) {
  require(file, cost, "cost/", "seconds", &ordered_json::is_object, "an object");
  for (const auto& [key, seconds] : cost["seconds"].items())
    if (!seconds.is_number()) fail(file, "cost/seconds/" + key, seconds, "a number");
  require(file, cost, "cost/", "dofs", &ordered_json::is_number, "a number");
  for (const char* key : {"time_steps", "cycles", "peak_memory_bytes"})
    require(file, cost, "cost/", key, &ordered_json::is_number, "a number", true);
  for (const char* count : {"dofs", "time_steps", "cycles"})  // which the report takes as integers
    if (cost.contains(count) && !(std::abs(cost[count].get<double>()) <= most_of_anything))
      fail(file, std::string("cost/") + count, cost[count], "at most 2e9");
}

void require_error_estimate(const fs::path& file, const ordered_json& fe) {
  require(file, fe, "fe/", "error_estimate", &ordered_json::is_object, "an object", true);
  if (!fe.contains("error_estimate")) return;
  for (const auto& [quantity, bar] : fe["error_estimate"].items()) {
    if (!bar.is_object()) continue;
    const std::string path = "fe/error_estimate/" + quantity + "/";
    require(file, bar, path, "shares", &ordered_json::is_object, "an object", true);
    if (bar.contains("shares")) require_objects_in(file, bar["shares"], path + "shares/");
  }
}

/// Everything that the report takes from a result is there and of its kind.
void require_result(const fs::path& file, const ordered_json& json) {
  if (!json.is_object()) throw InputError(fmt::format("{}: is no JSON object, must be a result", file.string()));
  require(file, json, "", "name", &ordered_json::is_string, "text");
  require(file, json, "", "pass", &ordered_json::is_boolean, "true or false");
  require(file, json, "", "proof", &ordered_json::is_string, "text", true);
  for (const char* key : {"scene", "mdr", "fe", "comparison", "cost"})
    require(file, json, "", key, &ordered_json::is_object, "an object");
  require_scene(file, json["scene"]);
  require_comparison(file, json["comparison"]);
  require_cost(file, json["cost"]);
  require_error_estimate(file, json["fe"]);
}

StoredResult read_result(const fs::path& file) {
  std::ifstream stream(file);
  try {
    StoredResult result{ordered_json::parse(stream), file.parent_path()};
    require_result(file, result.json);
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
  const auto& part = json.at(section);
  if (!part.contains(key) || !part[key].is_number()) return std::nan("");
  return part[key].get<double>();
}

std::string StoredResult::text(const char* section, const char* key) const {
  return json.at(section).value(key, std::string());
}

bool StoredResult::swept_over(const char* entry) const {
  const auto& scene = json.at("scene");
  return scene.contains("sweep") && scene["sweep"].value("entry", "") == entry;
}

double StoredResult::sweep_value() const {
  const auto& scene = json.at("scene");
  return scene.contains("sweep") ? scene["sweep"].value("value", 0.0) : 0;
}

std::string StoredResult::family() const {
  const auto& scene = json.at("scene");
  return scene.contains("sweep") ? scene["sweep"].value("family", "") : json.at("name").get<std::string>();
}

std::vector<StoredResult> read_results(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(fmt::format("{}: no such folder; expected one that fretval run has written", folder.string()));
  std::vector<StoredResult> results;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().filename() == "result.json") results.push_back(read_result(entry.path()));
  std::sort(results.begin(), results.end(), [](const StoredResult& a, const StoredResult& b) {
    return std::make_tuple(a.family(), a.sweep_value()) < std::make_tuple(b.family(), b.sweep_value());
  });
  return results;
}

std::string section_of(const fs::path& file, std::string (*section)(const ordered_json&)) {
  if (!fs::exists(file)) return "";
  std::ifstream stream(file);
  try {
    return section(ordered_json::parse(stream));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
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
