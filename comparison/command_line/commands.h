#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fretval {

/// What to do; returns the exit code.
using Command = std::function<int()>;

/// Adds the verbs new, explain, mdr, run, compare, check, report, trade, mesh and store to the command line; parsing
/// sets `command`, which must outlive it.
void add_commands(CLI::App& app, Command& command);

/// What is wrong with the verb of a command line, with the verbs that there are; empty: nothing, or there is none.
std::string unknown_verb(const CLI::App& app, const std::vector<std::string>& arguments);

/// What is wrong with the first option that the parsed verb does not have; empty: it has them all.
std::string unknown_option(const CLI::App& app, const std::vector<std::string>& arguments);

/// The manual page fretval(1), made from the help texts of the command line.
std::string man_page(const CLI::App& app);

/// Script of bash that completes verbs, options and files of the command line.
std::string bash_completion(const CLI::App& app);

}  // namespace fretval
