#pragma once

#include <set>
#include <string>
#include <vector>

namespace fretval {

/// Everything that is wrong with a case file, so that it can be said at once.
struct Problems {
  std::vector<std::string> messages;
  /// "SECTION" or "SECTION / ENTRY" of what was probably meant by a name that there is not: it is not missing as well.
  std::set<std::string> meant;
  /// Whether lines could not be understood: what seems to be missing may stand there.
  bool has_unread_lines = false;

  /// Once.
  void add(const std::string& message);
  /// Throws InputError with a line for each.
  void throw_if_any() const;
};

}  // namespace fretval
