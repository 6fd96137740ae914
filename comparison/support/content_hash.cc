#include "comparison/support/content_hash.h"

#include <fmt/format.h>

#include <cstdint>

namespace fretval {

std::string content_hash(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return fmt::format("{:016x}-{}", hash, bytes.size());
}

}  // namespace fretval
