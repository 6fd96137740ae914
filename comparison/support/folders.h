#pragma once

#include <filesystem>
#include <optional>

namespace fretval {

/// The meshes and cases that come with the program: share/fretval beside the folder of an installed program, wherever
/// that has been moved to; otherwise the source tree that it was built from. Throws std::filesystem::filesystem_error
/// if neither is there.
std::filesystem::path data_folder();

/// The folder of the data for a program that lies in program_folder.
std::filesystem::path data_folder_beside(const std::filesystem::path& program_folder);

/// Where this user's programs keep what they can make again: fretval in $XDG_CACHE_HOME, or else in $HOME/.cache (XDG
/// Base Directory Specification; folders that are not absolute count as not set). Empty: neither is set.
std::optional<std::filesystem::path> cache_folder();

/// A folder that this process alone writes to, as long as the object lives. The lock is the kernel's (flock) and goes
/// with the process, however it ends; nothing is left in the folder.
class FolderLock {
 public:
  /// Makes the folder if need be. Throws std::filesystem::filesystem_error if it cannot, or if another process has it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace fretval
