#pragma once

#include <array>
#include <cstddef>

namespace fretval {

/// Okabe and Ito's palette, distinguishable with colour-blind eyes; as in report.js.
inline const char* palette_colour(std::size_t k) {
  constexpr std::array<const char*, 9> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b87d00",
                                               "#3a9bd0", "#6a51a3", "#555555", "#a6761d"};
  return palette[k % palette.size()];
}

}  // namespace fretval
