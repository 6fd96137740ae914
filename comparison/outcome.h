#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "comparison/body.h"
#include "comparison/reference.h"
#include "comparison/scene.h"
#include "comparison/simulation.h"
#include "comparison/verdict.h"

namespace fretval {

/// A case computed both ways.
struct Outcome {
  Case scene;
  MdrScene mdr_scene;
  FemScene fem_scene;
  MdrAnswer mdr;
  FeAnswer fe;
  Verdict verdict;
};

/// The "mdr" object of result.json. SI units; null where nothing sticks.
nlohmann::ordered_json to_json(const MdrAnswer& answer);

/// The whole of result.json, with the keys of the documentation in docs/results.md.
nlohmann::ordered_json result_json(const Outcome& outcome, const Body& body, const NormalSimulation& normal);

/// Writes result.json, run.json, history.csv, contact.csv, profile.csv and, if the case asks for fields, the VTU files
/// into a folder, which is made if need be.
void write_outcome(const Outcome& outcome, const Body& body, const NormalSimulation& normal,
                   const mdr::NormalResponse& reference, const std::filesystem::path& folder);

}  // namespace fretval
