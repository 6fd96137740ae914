#pragma once

#include <filesystem>
#include <optional>

namespace fretval {

/// Where this user's programs keep what they can make again: fretval in $XDG_CACHE_HOME, or else in $HOME/.cache (XDG
/// Base Directory Specification; folders that are not absolute count as not set). Empty: neither is set.
std::optional<std::filesystem::path> cache_folder();

}  // namespace fretval
