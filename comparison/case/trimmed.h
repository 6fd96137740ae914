#pragma once

#include <string>

namespace fretval {

/// Without the blanks at either end.
inline std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r";
  const auto begin = text.find_first_not_of(blanks);
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

}  // namespace fretval
