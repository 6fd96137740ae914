#include "mdr/profiles/profile_rows.h"

#include <stdexcept>
#include <string>

#include "mdr/support/checks.h"

namespace fretval::mdr {

void require_profile_rows(const std::vector<double>& r, const std::vector<double>& f, std::size_t n_least) {
  if (r.size() != f.size() || r.size() < n_least)
    throw std::invalid_argument("profile table of " + std::to_string(r.size()) + " radii and " +
                                std::to_string(f.size()) + " heights: expected as many of both, and at least " +
                                std::to_string(n_least));
  for (std::size_t k = 0; k < r.size(); ++k) {
    const std::string row = " in row " + std::to_string(k + 1) + " of the profile table";
    require_non_negative("radius" + row, r[k]);
    require_finite("height" + row, f[k]);
    if (k > 0 && !(r[k] > r[k - 1])) reject("radius" + row, r[k], "must be greater than the one before");
  }
}

}  // namespace fretval::mdr
