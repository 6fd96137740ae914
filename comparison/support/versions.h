#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fretval {

/// Name and version of fretval and of the libraries that its numbers rest on.
std::vector<std::pair<std::string, std::string>> versions();

}  // namespace fretval
