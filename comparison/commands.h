#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace fretval {

constexpr int exit_agree = 0;
constexpr int exit_disagree = 1;
constexpr int exit_bad_input = 2;
constexpr int exit_numerics_failed = 3;
constexpr int exit_system_failed = 4;

/// What to do; returns the exit code.
using Command = std::function<int()>;

/// Adds the verbs mdr, run, check, report, trade and mesh to the command line; parsing sets `command`, which must
/// outlive it.
void add_commands(CLI::App& app, Command& command);

}  // namespace fretval
