#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fem/wear/wear_course.h"

namespace fretval {

/// A file that keeps the state of a course of wear, so that it goes on from there after its program was killed. It is
/// written aside and renamed, and has a checksum; a file that is damaged, or of another wear or program, counts as
/// none.
class WearCheckpoint {
 public:
  /// what: all that the course depends on, as text. An empty folder: nothing is kept.
  WearCheckpoint(const std::filesystem::path& folder, std::string what);

  /// The state that was kept last; empty: there is none. start: a state of the same wear, which is overwritten.
  [[nodiscard]] std::optional<fem::WearState> restored(fem::WearState start) const;

  /// Keeps a state. Where the file cannot be written, a warning says so, and nothing is kept from then on.
  void keep(const fem::WearState& state);

 private:
  std::filesystem::path file_;
  std::string what_;
};

}  // namespace fretval
