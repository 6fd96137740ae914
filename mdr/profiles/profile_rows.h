#pragma once

#include <cstddef>
#include <vector>

namespace fretval::mdr {

/// Throws std::invalid_argument, naming the row, unless there are as many heights as radii and at least n_least of
/// them, all finite, and the radii are not negative and increase.
void require_profile_rows(const std::vector<double>& r, const std::vector<double>& f, std::size_t n_least);

}  // namespace fretval::mdr
