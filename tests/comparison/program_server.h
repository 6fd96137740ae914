#pragma once

#include <string>

namespace fretval {

/// Forks a process that starts the program whenever a test asks for it, as the loading of its libraries takes longer
/// than most of what it is asked for. To be called while there are neither threads nor MPI.
void start_program_server();

/// Runs the program in a process of its own, with the environment of now and its outputs in files; words: of its
/// command line, as a shell would take them. Returns the exit code; -1: a signal has ended it.
int served_exit_code(const std::string& words, const std::string& out, const std::string& err);

}  // namespace fretval
