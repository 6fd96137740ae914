#include "comparison/support/resident_memory.h"

#include <malloc.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace fretval {
namespace {

/// An entry of /proc/self/status in bytes.
std::optional<double> status_bytes(const std::string& entry) {
  std::ifstream stream("/proc/self/status");
  for (std::string key; stream >> key; stream.ignore(4096, '\n')) {
    if (key != entry) continue;
    double kilobytes = 0;
    if (stream >> kilobytes) return 1024 * kilobytes;
    break;
  }
  return std::nullopt;
}

/// Lets the high-water mark start again from what is resident now.
bool reset_peak() {
  std::ofstream stream("/proc/self/clear_refs");
  stream << 5 << std::flush;
  return stream.good();
}

}  // namespace

std::optional<double> resident_bytes() {
  malloc_trim(0);
  return status_bytes("VmRSS:");
}

ResidentGrowth::ResidentGrowth() {
  malloc_trim(0);
  if (reset_peak()) start_ = status_bytes("VmRSS:");
}

std::optional<double> ResidentGrowth::peak_bytes() const {
  const auto peak = status_bytes("VmHWM:");
  if (!start_ || !peak) return std::nullopt;
  return std::max(0.0, *peak - *start_);
}

}  // namespace fretval
