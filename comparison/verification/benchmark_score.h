#pragma once

#include <istream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/quantities/quantity.h"

namespace fretval {

/// docs/benchmarks.json, which is compiled into the program.
extern const std::string_view benchmarks_json;

/// Reads the answer of another code to a benchmark, by quantity in SI units, from a table of one row: names of
/// quantities as in docs/benchmarks.json, units, numbers. Quantities that no benchmark has are left out. Throws
/// InputError that names the source and what would be valid.
std::map<Quantity, double> read_foreign_answer(std::istream& stream, const std::string& source_name);

/// A quantity of a benchmark beside the value of another code.
struct ScoreRow {
  Quantity quantity;
  std::optional<double> value;            ///< of the other code; empty: it has none
  std::optional<double> mdr, fe;          ///< empty: there is none, like a stick radius where nothing sticks
  double error_bar = 0;                   ///< of fe
  std::optional<double> difference = {};  ///< of value from fe, or from MDR where fe has none, over its scale
  bool agrees = true;                     ///< whether value is within the tolerance, or missing
  std::string remark = {};                ///< "is the stick radius, shakedown", or why it does not agree
};

/// The rows of a benchmark by its name. Radii are compared over the largest contact radius, all else relatively. Throws
/// InputError for an unknown name, and if the other code has no quantity of the benchmark.
std::vector<ScoreRow> benchmark_score(const std::string& benchmark, const std::map<Quantity, double>& foreign,
                                      double tolerance);

/// Names of all benchmarks, in the order of docs/benchmarks.json.
std::vector<std::string> benchmark_names();

/// All rows for a terminal, and how many agree.
std::string score_text(const std::string& benchmark, const std::vector<ScoreRow>& rows, double tolerance);

/// All rows as JSON, for scripts.
nlohmann::ordered_json score_json(const std::string& benchmark, const std::vector<ScoreRow>& rows, double tolerance);

}  // namespace fretval
