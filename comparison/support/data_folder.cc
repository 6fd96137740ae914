#include "comparison/support/data_folder.h"

#include <system_error>

namespace fretval {

namespace fs = std::filesystem;

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

}  // namespace fretval
