#include "comparison/results_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "comparison/case.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

StoredResult read_result(const fs::path& file) {
  std::ifstream stream(file);
  try {
    StoredResult result{nlohmann::ordered_json::parse(stream), file.parent_path()};
    for (const char* key : {"name", "pass", "scene", "mdr", "fe", "comparison", "cost"})
      if (!result.json.contains(key))
        throw InputError(
            fmt::format("{}: the key \"{}\" is missing; is this a result of fretval?", file.string(), key));
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
  if (results.empty())
    throw InputError(fmt::format("{}: there is no result.json below it; expected a folder that fretval run has written",
                                 folder.string()));
  std::sort(results.begin(), results.end(), [](const StoredResult& a, const StoredResult& b) {
    return std::make_tuple(a.family(), a.sweep_value()) < std::make_tuple(b.family(), b.sweep_value());
  });
  return results;
}

std::optional<nlohmann::ordered_json> read_json(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  std::ifstream stream(file);
  try {
    return nlohmann::ordered_json::parse(stream);
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
