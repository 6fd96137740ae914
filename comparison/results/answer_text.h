#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/results/case_result.h"
#include "comparison/results/unit_text.h"

namespace fretval {

/// A quantity by both methods, with units, for finite elements with its error bar; the difference is that of
/// result.json.
struct AnswerRow {
  std::string title, fe, mdr, difference;
  std::string remark = {};  ///< the verdict, unless it agrees or there is none
  bool asked = true;        ///< whether it is asked for; other rows come after these
};

/// The answer to a case: what happens, the verdict on MDR (see verdict_text.h), then each quantity that is compared.
struct Answer {
  std::string plain, verdict;
  std::vector<AnswerRow> rows;
  std::string model = {};        ///< how good MDR is as a model, or why that is not known; empty: no such result
  std::string half_space = {};   ///< error of MDR over a half-space, for another body; otherwise empty
  std::string rings = {};        ///< that a given mesh has too few rings, and how many are needed; otherwise empty
  std::string sensitivity = {};  ///< of MDR's stick radii to friction and relaxed modulus; empty: no closed form
};

/// The answer from a result.json.
Answer answer_of(const nlohmann::ordered_json& result);

/// Scales of the differences and error bars of a result.json; 0 where it does not have them.
Scales scales_of(const nlohmann::ordered_json& result);

/// The value of a quantity by finite elements in a result.json, with its error bar as the uncertainty. Empty: there is
/// none.
std::optional<Reading> fe_reading(const nlohmann::ordered_json& result, Quantity quantity);

/// "0 to 502.1 ± 0.4 µm, 610 ± 1 to 702 ± 1 µm", of a list of annuli in such a JSON; "none" without any.
std::string annuli_text(const nlohmann::ordered_json& annuli);

/// A value by MDR with its unit, and with its error where springs were stepped for it; "none" if there is none. mdr:
/// the "mdr" of a result.json or of `fretval mdr --json`.
std::string mdr_text(const nlohmann::ordered_json& mdr, Quantity quantity, const Scales& scales);

/// Period in s of the motion in the "scene" of a result.json, if it has one frequency in both directions or is a path
/// that repeats; otherwise empty.
std::optional<double> period_of(const nlohmann::ordered_json& scene);

/// A line of a table for the terminal.
std::string answer_line(const std::string& title, const std::string& first, const std::string& second = {},
                        const std::string& remark = {});

/// The answer to a case for the terminal. json: its result_json.
std::string answer_text(const CaseResult& result, const nlohmann::ordered_json& json);

/// The answer for the terminal from a result.json that an earlier run has written; about wear it tells only how far it
/// has come.
std::string kept_answer_text(const nlohmann::ordered_json& json);

}  // namespace fretval
