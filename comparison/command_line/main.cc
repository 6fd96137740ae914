#include <cstdio>

#include "comparison/command_line/ending.h"
#include "comparison/command_line/program.h"

int main(int argc, char** argv) {
  try {
    return fretval::run_program(argc, argv);
  } catch (...) {  // from a message
    std::fputs("error: fretval ended before it could say why\n", stderr);
    return fretval::exit_system_failed;
  }
}
