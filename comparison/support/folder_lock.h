#pragma once

#include <filesystem>

namespace fretval {

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
