#include "comparison/command_line/output_file.h"

#include <fmt/format.h>

#include <filesystem>

#include "comparison/case/case.h"

namespace fretval {

namespace fs = std::filesystem;

void prepare_output_file(const char* option, const std::string& file) {
  if (fs::is_directory(file))
    throw InputError(fmt::format("{}: is a folder; {} expects the name of a file", file, option));
  if (const auto folder = fs::path(file).parent_path(); !folder.empty()) fs::create_directories(folder);
}

}  // namespace fretval
