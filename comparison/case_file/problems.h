#pragma once

#include <set>
#include <string>
#include <vector>

namespace fretval {

/// Everything that is wrong with a case file, so that it can be said at once.
struct Problems {
  std::vector<std::string> messages;
  /// "SECTION" or "SECTION / ENTRY" that was probably meant by an unknown name: it is not reported as missing in
  /// addition.
  std::set<std::string> meant;
  /// Whether lines could not be understood: entries that seem to be missing may stand there.
  bool has_unread_lines = false;

  /// Adds a message, unless it is there already.
  void add(const std::string& message);
  /// Throws InputError with a line for each.
  void throw_if_any() const;
};

}  // namespace fretval
