#pragma once

#include <string>

namespace fretval {

/// Makes the folder of the file that an option names, before minutes of computing and not after. file: empty if none is
/// asked for. Throws InputError if the file is a folder.
void prepare_output_file(const char* option, const std::string& file);

}  // namespace fretval
