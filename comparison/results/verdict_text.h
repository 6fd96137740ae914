#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/verdict.h"

namespace fretval {

/// One quantity of "comparison" in a result.json, of the present or of the first version.
struct StoredDifference {
  Quantity quantity;
  double size;  ///< of the difference, or of the value that only one of the methods finds
  double tolerance, bar;
  std::optional<Verdict> verdict;
  bool asked, only_one;
};
std::vector<StoredDifference> stored_differences(const nlohmann::ordered_json& result);

/// Whether the "fe" or the "mdr" of a result.json finds that the whole contact slides.
bool slides(const nlohmann::ordered_json& method);

Outcome stored_outcome(const nlohmann::ordered_json& result);

/// What happens under the indenter, before any comparison: "the inner 0.793 mm of a contact of 1.10 mm sticks for good;
/// the ring outside wears, out to 1.24 mm".
std::string plain_answer(const nlohmann::ordered_json& result);

/// The verdict in a sentence: "both stick radii, the largest contact radius and the largest normal force agree to
/// 6.9e-05; 3 of 8 other quantities are not resolved".
std::string verdict_sentence(const nlohmann::ordered_json& result);

}  // namespace fretval
