#pragma once

#include <string>

namespace CLI {
class App;
}

namespace fretval {

/// The manual page fretval(1), made from the help texts of the command line.
std::string man_page(const CLI::App& app);

/// Script of bash that completes verbs, options and files of the command line.
std::string bash_completion(const CLI::App& app);

}  // namespace fretval
