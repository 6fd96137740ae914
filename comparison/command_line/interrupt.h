#pragma once

#include <string>

namespace fretval {

/// What the user is told on the standard error who ends the program with Ctrl-C, or with SIGTERM, as mpirun and batch
/// systems do; it ends then as it would otherwise. The last call holds.
void say_on_interrupt(const std::string& message);

}  // namespace fretval
