#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "comparison/results/results_folder.h"
#include "tests/comparison/run_fretval.h"

namespace fretval {

/// A result.json as a run has written it: phase (a point of a sweep), single, limiting or tags.
inline nlohmann::ordered_json stored_result(const std::string& name = "phase") {
  const auto seeds = std::filesystem::path(FRETVAL_SOURCE_DIR) / "tests/fuzz/seeds/result_json";
  return nlohmann::ordered_json::parse(text_of(seeds / (name + ".json")));
}

/// A row of exact.json.
inline nlohmann::ordered_json stored_convergence_row() {
  return {{"solution", "Hertz"},
          {"quantity", "force"},
          {"source", "Hertz 1882"},
          {"refined", "rings"},
          {"resolutions", {16, 32}},
          {"errors", {1e-3, 2.5e-4}},
          {"observed_order", 2.0},
          {"expected_order", 2},
          {"tolerance", 1e-3},
          {"verdict", "pass"},
          {"note", ""}};
}

}  // namespace fretval
