#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "comparison/results/answer_text.h"
#include "comparison/results/case_inputs.h"
#include "comparison/results/results_folder.h"
#include "comparison/results/verdict_text.h"
#include "comparison/run/batch.h"
#include "comparison/support/versions.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::vector<fs::path> files_of(const Case& input) {
  std::vector<fs::path> files{input.indenter.table, input.elastomer.branches_file, input.body.mesh};
  if (input.elastomer.master_curve) files.emplace_back(input.elastomer.master_curve->table);
  if (input.motion.path) files.emplace_back(input.motion.path->file);
  if (input.wear_kinetics) {
    files.emplace_back(input.wear_kinetics->profile);
    files.emplace_back(input.wear_kinetics->rings);
  }
  if (input.measured) files.emplace_back(input.measured->loop);
  return files;
}

bool is_newer_than_all(const fs::path& result, const std::vector<fs::path>& files) {
  const auto written = fs::last_write_time(result);
  for (const auto& file : files) {
    std::error_code error;
    if (file.empty()) continue;
    const auto changed = fs::last_write_time(file, error);
    if (error || changed > written) return false;
  }
  return true;
}

/// The JSON in a file; null if there is no file or no JSON in it.
ordered_json json_in(const fs::path& file) {
  std::ifstream stream(file);
  return stream ? ordered_json::parse(stream, nullptr, false) : ordered_json();
}

bool is_of_this_version(const fs::path& folder) {
  const auto run = json_in(folder / "run.json");
  if (!run.is_object() || !run.contains("versions") || !run["versions"].is_object()) return false;
  for (const auto& [name, version] : versions())
    if (run["versions"].value(name, "") != version) return false;
  return true;
}

bool is_of_this_case(const ordered_json& result, const Case& input, Proof proof) {
  if (!result.is_object() || result.value("schema", ordered_json()) != result_schema) return false;
  if (result.value("name", "") != input.name || result.value("proof", "") != name_of(proof)) return false;
  return result.contains("scene") && result["scene"].is_object() &&
         result["scene"].value("inputs", ordered_json()) == ordered_json::parse(inputs_json(input).dump());
}

}  // namespace

std::optional<BatchLine> kept_line(const PreparedCase& prepared, Proof proof, const fs::path& output) {
  const auto folder = output / prepared.input.name, file = folder / "result.json";
  if (!fs::exists(file) || !is_of_this_version(folder)) return std::nullopt;
  const auto result = json_in(file);
  if (!is_of_this_case(result, prepared.input, proof) || !is_newer_than_all(file, files_of(prepared.input)))
    return std::nullopt;
  BatchLine line;
  line.name = prepared.input.name;
  line.outcome = stored_outcome(result);
  line.answer = kept_answer_text(result);
  line.json = result.dump();
  line.largest_use = largest_use(result);
  return line;
}

}  // namespace fretval
