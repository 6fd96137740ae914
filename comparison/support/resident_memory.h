#pragma once

#include <optional>

namespace fretval {

/// Bytes of the process that are resident after freed memory went back to the system; empty where the system does not
/// tell. Linux only.
std::optional<double> resident_bytes();

/// Measures by how much the resident memory of the process peaks above where it was, from construction on. Freed
/// memory goes back to the system first, so that its re-use counts. Linux only, and for one measurement at a time: the
/// peak belongs to the process, whatever its threads do.
class ResidentGrowth {
 public:
  ResidentGrowth();
  /// Bytes since construction; empty where the system does not tell.
  [[nodiscard]] std::optional<double> peak_bytes() const;

 private:
  std::optional<double> start_;
};

}  // namespace fretval
