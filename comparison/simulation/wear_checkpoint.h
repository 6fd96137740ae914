#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fem/wear/wear_course.h"

namespace fretval {

/// A file that keeps how far a wear has come, so that it goes on from there after its program was killed. Written aside
/// and renamed, with a checksum; one that is damaged, or of another wear or program, counts as none.
class WearCheckpoint {
 public:
  /// what: all that the course depends on, as text. An empty folder: nothing is kept.
  WearCheckpoint(const std::filesystem::path& folder, std::string what);

  /// The state that was kept last. start: of the same wear.
  [[nodiscard]] std::optional<fem::WearState> restored(fem::WearState start) const;

  /// Where a file cannot be written, a warning says so, and no more is kept.
  void keep(const fem::WearState& state);

 private:
  std::filesystem::path file_;
  std::string what_;
};

}  // namespace fretval
