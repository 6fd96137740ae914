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

/// A trade.json as `fretval trade` writes it, of five levels: the second is too coarse for 1e-3, the third the tool's.
inline nlohmann::ordered_json stored_trade() {
  return nlohmann::ordered_json::parse(R"({
    "name": "case <b>", "file": "case.prm", "reference_setting": {},
    "levels": [
      {"kind": "condensed", "setting": {"elements_per_radius": 8, "degree": 2, "growth": 0.3, "far_radius": 12.0, "steps_per_cycle": 24},
       "axes": {"rings": 8.0}, "error": 8e-3, "errors": {"stick_radius_shakedown": 8e-3, "normal_force_max": 1e-4}, "seconds": 0.25, "failure": null},
      {"kind": "condensed", "setting": {"elements_per_radius": 16, "degree": 2, "growth": 0.3, "far_radius": 12.0, "steps_per_cycle": 24},
       "axes": {"rings": 16.0}, "error": 1e-3, "errors": {"stick_radius_shakedown": 1e-3}, "seconds": 0.5, "failure": null},
      {"kind": "all dofs", "setting": {"elements_per_radius": 8, "degree": 2, "growth": 0.3, "far_radius": 12.0, "steps_per_cycle": 24},
       "axes": {}, "error": 8e-3, "errors": {}, "seconds": 1234.0, "failure": null},
      {"kind": "springs", "setting": {"springs": 50, "steps_per_cycle": 45},
       "axes": {}, "error": null, "errors": {}, "seconds": null, "failure": "not periodic"},
      {"kind": "closed form", "setting": {}, "axes": {}, "error": 0.0, "errors": {}, "seconds": 2.5e-5, "failure": null}],
    "front": [0, 1],
    "axes": {"rings": {"levels": [0, 1], "values": [8.0, 16.0], "errors": [8e-3, 1e-3], "power": -3.0},
             "order": {"levels": [], "values": [], "errors": [], "power": null}},
    "recommendations": [
      {"tolerance": 1e-2, "cheapest": 0, "chosen": 1, "chosen_meets_tolerance": true},
      {"tolerance": 1e-4, "cheapest": null, "chosen": 1, "chosen_meets_tolerance": false}]})");
}

}  // namespace fretval
