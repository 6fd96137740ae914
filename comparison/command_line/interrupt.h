#pragma once

#include <string>

namespace fretval {

/// Sets the message on the standard error for a user who ends the program with Ctrl-C, or by SIGTERM as mpirun and
/// batch systems do; after it the program ends as it would otherwise. The last call holds.
void say_on_interrupt(const std::string& message);

}  // namespace fretval
