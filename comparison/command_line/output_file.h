#pragma once

#include <string>

namespace fretval {

/// Makes room for the file that an option names, before minutes of computing and not after: the folder that it lies in
/// is made. Empty: none is asked for. Throws InputError if it is a folder itself.
void prepare_output_file(const char* option, const std::string& file);

}  // namespace fretval
