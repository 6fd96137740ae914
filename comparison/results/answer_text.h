#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "comparison/results/case_result.h"

namespace fretval {

/// Why a path that is passed once has one stick radius alone.
constexpr const char* no_shakedown_in_a_pass =
    "a single pass has no periodic state: never slipped is the only stick radius";

/// A value in SI units for people: with the prefix that leaves one to three digits before the point, of its bar at most
/// two, and as many digits as the bar allows, or six: "0.79312 ± 0.00004 mm". bar: absolute; 0, or less than nine
/// decimals show: none is known. unit: "m", "N", ….
std::string with_unit(double value, double bar, const std::string& unit);

/// The prefix that leaves one to three digits before the point.
struct UnitPrefix {
  const char* name;
  double factor;
};
UnitPrefix prefix_for(double value);

/// A quantity by both methods, with units, the finite elements' with its error bar; the difference as result.json has
/// it.
struct AnswerRow {
  std::string title, fe, mdr, difference;
  bool passes;
};

/// The answer to a case: what became of MDR in a sentence, then each quantity that is compared.
struct Answer {
  std::string verdict;
  std::vector<AnswerRow> rows;
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

/// A line of a table for the terminal.
std::string answer_line(const std::string& title, const std::string& first, const std::string& second = {});

/// "1.5 mm³"
std::string volume_text(double cubic_metres);

/// The answer to a case for the terminal. json: its result_json.
std::string answer_text(const CaseResult& result, const nlohmann::ordered_json& json);

}  // namespace fretval
