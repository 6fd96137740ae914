#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "comparison/data/motion_kind.h"

namespace fretval {

/// Version of result.json, see docs/result.schema.json: a new one where a key changes its meaning or goes.
constexpr int result_schema = 2;

/// A result.json and where it lies.
struct StoredResult {
  nlohmann::ordered_json json;
  std::filesystem::path folder;

  /// A number of a section ("mdr", "fe", "scene"); NaN where it is null or absent.
  [[nodiscard]] double number(const char* section, const char* key) const;
  [[nodiscard]] std::string text(const char* section, const char* key) const;
  [[nodiscard]] std::string name() const { return json.at("name").get<std::string>(); }
  /// Its place in a sweep; an empty object: it is no point of one.
  [[nodiscard]] const nlohmann::ordered_json& sweep() const;
  [[nodiscard]] std::string entry() const { return sweep().value("entry", ""); }
  [[nodiscard]] double sweep_value() const { return sweep().value("value", 0.0); }
  /// Of a map over two entries; empty: it is no point of a map.
  [[nodiscard]] std::string second_entry() const { return sweep().value("second_entry", ""); }
  [[nodiscard]] double second_value() const { return sweep().value("second_value", 0.0); }
  /// Whether it is a point of a sweep over this entry alone.
  [[nodiscard]] bool swept_over(const char* one) const { return entry() == one && second_entry().empty(); }
  /// Name of the sweep, or the name of the case.
  [[nodiscard]] std::string family() const { return sweep().empty() ? name() : sweep().value("family", ""); }
  /// Whether MDR does not hold for the profile, so that nothing is compared.
  [[nodiscard]] bool is_beyond_mdr() const { return json.contains("not_compared"); }
  /// Whether both directions move with one harmonic of the same frequency, as in the paper.
  [[nodiscard]] bool has_one_frequency() const;
  /// Whether a force is prescribed.
  [[nodiscard]] bool has_forces() const;
  [[nodiscard]] MotionKind motion_kind() const { return stored_motion_kind(json.at("scene")); }
  /// Whether its motion repeats, or finite elements step a near cycle in its place.
  [[nodiscard]] bool has_period() const;
  /// Name of the cycle that finite elements step to the end: "period", which repeats, "near cycle" or "pass".
  [[nodiscard]] const char* cycle_name() const;
};

/// Every result.json below a folder, by family and sweep value; maybe none. Throws InputError if there is no such
/// folder or one cannot be read.
std::vector<StoredResult> read_results(const std::filesystem::path& folder);

/// What a section of the report makes of a JSON file; null if there is none. Throws InputError if it is no JSON, or
/// none that the section takes.
nlohmann::ordered_json section_of(const std::filesystem::path& file,
                                  nlohmann::ordered_json (*section)(const nlohmann::ordered_json&));

/// Names of the columns of a CSV file; empty if it is not there.
std::vector<std::string> column_names(const std::filesystem::path& file);

/// Two columns of a CSV file; empty if the file or a column is not there.
std::pair<std::vector<double>, std::vector<double>> read_columns(const std::filesystem::path& file,
                                                                 const std::string& x, const std::string& y);

}  // namespace fretval
