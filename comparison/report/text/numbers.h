#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "comparison/results/results_folder.h"

namespace fretval {

/// A number in a format; a dash if it is not finite or no number.
std::string number_text(const nlohmann::ordered_json& value, const char* format = "{:.1e}");

/// "1 case", "2 cases"
std::string counted(std::size_t n, const std::string& noun);

/// A comparison, by its key in result.json; a dash where there is none: difference, error bar, "difference ± bar".
std::string difference_text(const StoredResult& result, const char* key);
std::string bar_text(const StoredResult& result, const char* key);
std::string difference_with_bar(const StoredResult& result, const char* key);

/// A number that the case file prescribes, by the name of its entry, in a section or in the first one that has it; NaN
/// if there is none.
double input_number(const StoredResult& result, const char* name, const char* section = nullptr);
/// A word that the case file prescribes, by the name of the entry; empty if it is not there.
std::string input_word(const StoredResult& result, const char* name);

/// A length of "fe", "mdr" or "scene" with its unit; a dash where there is none.
std::string length_text(const StoredResult& result, const char* section, const char* key);

}  // namespace fretval
