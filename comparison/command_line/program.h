#pragma once

namespace fretval {

/// All of the program, of a process that runs nothing else. Returns the exit code (comparison/command_line/ending.h).
int run_program(int argc, char** argv);

}  // namespace fretval
