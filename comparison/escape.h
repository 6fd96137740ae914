#pragma once

#include <string>

namespace fretval {

/// Text with the characters that mean something in HTML and XML replaced by entities.
std::string html_escaped(const std::string& text);

}  // namespace fretval
