#pragma once

#include <string>

namespace fretval {

/// Text with the characters that mean something in HTML and XML replaced by entities.
std::string html_escaped(const std::string& text);

/// Question marks for what would steer a terminal, but for ends of lines.
std::string without_control_characters(std::string text);

}  // namespace fretval
