#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace fretval {

/// Hands out the numbers 0..n-1, each once, to n_ranks ranks that work at different speeds. Neighbours often share
/// something that is made once in each process: therefore each rank has a stretch of its own, all of equal length, and
/// a rank that has finished its stretch takes numbers from the far end of the longest stretch that is left.
class Shares {
 public:
  Shares(std::size_t n, std::size_t n_ranks);

  /// The next number for a rank; empty: none is left. from_front: of its own stretch, for threads that work from both
  /// ends towards the middle.
  std::optional<std::size_t> next(std::size_t rank, bool from_front);

 private:
  struct Stretch {
    std::size_t front, back;
    [[nodiscard]] std::size_t size() const { return back - front; }
  };
  std::vector<Stretch> stretches_;
};

}  // namespace fretval
