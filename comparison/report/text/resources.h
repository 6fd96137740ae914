#pragma once

#include <map>
#include <string>
#include <string_view>

namespace fretval {

/// What is compiled into the program by embed.js, by file name: templates/*, d3.js and katex.css.
const std::map<std::string, std::string_view>& resources();

}  // namespace fretval
