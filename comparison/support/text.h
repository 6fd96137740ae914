#pragma once

#include <string>
#include <vector>

namespace fretval {

/// The candidate that a mistyped word most likely means: the one with the fewest letters missing, too many, wrong or
/// swapped with their neighbour, whatever the case, if they are at most this share of the longer of both; otherwise
/// empty. The first of equally near ones.
std::string closest(const std::string& word, const std::vector<std::string>& candidates, double share = 1.0 / 3);

/// "; did you mean CANDIDATE?", or nothing.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates);

/// Text with the characters that mean something in HTML and XML replaced by entities.
std::string html_escaped(const std::string& text);

/// The text with question marks in the place of characters that would control a terminal, except ends of lines.
std::string without_control_characters(std::string text);

}  // namespace fretval
