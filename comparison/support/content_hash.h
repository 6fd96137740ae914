#pragma once

#include <string>

namespace fretval {

/// 16 hexadecimal digits that tell one content from another (Fowler, Noll and Vo, FNV-1a in 64 bits), and its number of
/// bytes, as "1f2e3d4c5b6a7988-5120". It is the same on every machine, and no protection against forgery.
std::string content_hash(const std::string& bytes);

}  // namespace fretval
