#include "comparison/support/folders.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <system_error>

namespace fretval {

namespace fs = std::filesystem;

namespace {

std::optional<std::filesystem::path> absolute_folder(const char* variable) {
  const char* value = std::getenv(variable);
  if (value == nullptr || *value != '/') return std::nullopt;
  return value;
}

}  // namespace

fs::path data_folder_beside(const fs::path& program_folder) {
  const auto installed = program_folder.parent_path() / "share" / "fretval";
  for (const fs::path& folder : {installed, fs::path(FRETVAL_SOURCE_TREE)})
    if (fs::is_directory(folder / "meshes" / "small")) return folder;
  throw fs::filesystem_error("the data of the program are not there", installed,
                             std::make_error_code(std::errc::no_such_file_or_directory));
}

fs::path data_folder() {
  return data_folder_beside(fs::read_symlink("/proc/self/exe").parent_path());
}

std::optional<std::filesystem::path> cache_folder() {
  if (const auto cache = absolute_folder("XDG_CACHE_HOME")) return *cache / "fretval";
  if (const auto home = absolute_folder("HOME")) return *home / ".cache" / "fretval";
  return std::nullopt;
}

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
