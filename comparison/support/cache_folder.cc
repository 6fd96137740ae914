#include "comparison/support/cache_folder.h"

#include <cstdlib>

namespace fretval {
namespace {

std::optional<std::filesystem::path> absolute_folder(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || *value != '/') return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::filesystem::path> cache_folder() {
  if (const auto cache = absolute_folder("XDG_CACHE_HOME")) return *cache / "fretval";
  if (const auto home = absolute_folder("HOME")) return *home / ".cache" / "fretval";
  return std::nullopt;
}

}  // namespace fretval
