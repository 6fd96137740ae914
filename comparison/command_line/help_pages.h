#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fretval {

/// The manual page fretval(1), of what the command line says of itself.
std::string man_page(const CLI::App& app);

/// Completion of verbs, options and files for bash, likewise.
std::string bash_completion(const CLI::App& app);

}  // namespace fretval
