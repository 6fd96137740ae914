#pragma once

#include <filesystem>

namespace fretval {

/// The meshes and cases that come with the program: share/fretval beside the folder of an installed program, wherever
/// that has been moved to; otherwise the source tree that it was built from. Throws std::filesystem::filesystem_error
/// if neither is there.
std::filesystem::path data_folder();

/// The folder of the data for a program that lies in program_folder.
std::filesystem::path data_folder_beside(const std::filesystem::path& program_folder);

}  // namespace fretval
