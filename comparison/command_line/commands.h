#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace fretval {

/// What to do; returns the exit code.
using Command = std::function<int()>;

/// Adds the verbs new, explain, mdr, run, compare, check, report, trade, mesh and store to the command line; parsing
/// sets `command`, which must outlive it.
void add_commands(CLI::App& app, Command& command);

}  // namespace fretval
