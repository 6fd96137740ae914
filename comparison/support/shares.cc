#include "comparison/support/shares.h"

#include <algorithm>

namespace fretval {

Shares::Shares(std::size_t n, std::size_t n_ranks) {
  for (std::size_t rank = 0; rank < n_ranks; ++rank)
    stretches_.push_back({n * rank / n_ranks, n * (rank + 1) / n_ranks});
}

std::optional<std::size_t> Shares::next(std::size_t rank, bool from_front) {
  auto& own = stretches_[rank];
  if (own.size() > 0) return from_front ? own.front++ : --own.back;
  auto& longest = *std::max_element(stretches_.begin(), stretches_.end(),
                                    [](const Stretch& a, const Stretch& b) { return a.size() < b.size(); });
  if (longest.size() == 0) return std::nullopt;
  return --longest.back;
}

}  // namespace fretval
