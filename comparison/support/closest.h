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

}  // namespace fretval
