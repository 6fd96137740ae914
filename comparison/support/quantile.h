#pragma once

#include <optional>
#include <vector>

namespace fretval {

/// The value that a share of the values, 0 to 1, does not exceed (nearest rank); empty for none.
std::optional<double> quantile(std::vector<double> values, double share);

}  // namespace fretval
