#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/results/case_result.h"
#include "comparison/results/unit_text.h"

namespace fretval {

/// A quantity by both methods, with units, the finite elements' with its error bar; the difference as result.json has
/// it.
struct AnswerRow {
  std::string title, fe, mdr, difference;
  std::string remark = {};  ///< the verdict, unless it agrees or there is none
  bool asked = true;        ///< for; the others come after those that are
};

/// The answer to a case: what happens, what became of MDR (see verdict_text.h), then each quantity that is compared.
struct Answer {
  std::string plain, verdict;
  std::vector<AnswerRow> rows;
  std::string model = {};        ///< how good MDR is as a model, or why the maps do not know; empty: no result of that
  std::string half_space = {};   ///< by how much MDR over a half-space would be off, of another body; otherwise empty
  std::string rings = {};        ///< that a given mesh has too few, and how many it takes; otherwise empty
  std::string sensitivity = {};  ///< of MDR's stick radii to friction and relaxed modulus; empty: no closed form
};

/// From a result.json.
Answer answer_of(const nlohmann::ordered_json& result);

/// What its differences and error bars are over; 0 where it does not have that.
Scales scales_of(const nlohmann::ordered_json& result);

/// What finite elements say of a quantity in a result.json, with its error bar as the uncertainty. Empty: they do not.
std::optional<Reading> fe_reading(const nlohmann::ordered_json& result, Quantity quantity);

/// "its image g(x) falls for x = 502 to 600 µm. MDR's springs would bear +3.1 % and reach -0.2 % further, at rest at
/// the largest indentation": of the key "not_compared".
std::string beyond_text(const nlohmann::ordered_json& not_compared);

/// "0 to 502.1 ± 0.4 µm, 610 ± 1 to 702 ± 1 µm", of a list of annuli in such a JSON; "none" without any.
std::string annuli_text(const nlohmann::ordered_json& annuli);

/// A value of MDR, of the "mdr" of a result.json or of `fretval mdr --json`, null for none: with its unit, and where
/// springs were stepped for it with what they may be off by; "none".
std::string mdr_text(const nlohmann::ordered_json& mdr, Quantity quantity, const Scales& scales);

/// Of a cycle, s, of the "scene" of a result.json: of one frequency in both directions, or of a path that repeats.
std::optional<double> period_of(const nlohmann::ordered_json& scene);

/// A line of a table for the terminal.
std::string answer_line(const std::string& title, const std::string& first, const std::string& second = {},
                        const std::string& remark = {});

/// The answer to a case for the terminal. json: its result_json.
std::string answer_text(const CaseResult& result, const nlohmann::ordered_json& json);

/// The same of a result.json that an earlier run has written; of wear no more than how far it has come.
std::string kept_answer_text(const nlohmann::ordered_json& json);

}  // namespace fretval
