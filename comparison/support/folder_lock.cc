#include "comparison/support/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace fretval {

namespace fs = std::filesystem;

FolderLock::FolderLock(const fs::path& folder) {
  fs::create_directories(folder);
  const auto fail = [&](const char* what) {
    throw fs::filesystem_error(what, folder, std::error_code(errno, std::generic_category()));
  };
  // Closed in programs that a library starts: they must not keep the lock of a run that was killed.
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0) fail("cannot open the folder of the results");
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  const int reason = errno;
  close(descriptor_);
  errno = reason;
  fail(reason == EWOULDBLOCK ? "another fretval is writing to this folder; wait for it, or choose another one with -o"
                             : "cannot lock the folder of the results");
}

FolderLock::~FolderLock() {
  close(descriptor_);
}

}  // namespace fretval
