#pragma once

#include <string>

namespace fretval {

/// Text with the characters that mean something in HTML and XML replaced by entities.
std::string html_escaped(const std::string& text);

/// The text with question marks in the place of characters that would control a terminal, except ends of lines.
std::string without_control_characters(std::string text);

}  // namespace fretval
