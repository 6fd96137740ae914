#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace fretval {

/// Pseudo-random numbers that are the same with every library: the standard fixes what std::seed_seq and
/// std::mt19937_64 give, but not what its distributions make of that.
class RandomNumbers {
 public:
  /// Streams of different seeds are independent. The lower 32 bits of each seed count.
  explicit RandomNumbers(const std::vector<std::uint64_t>& seeds);

  /// A number in [from, to), uniformly distributed.
  double uniform(double from, double to);
  /// A number in [from, to), both positive, with its logarithm uniformly distributed.
  double log_uniform(double from, double to);
  bool chance(double probability);
  /// A number from 0 to n - 1; n positive, at most 2^32.
  std::size_t index(std::size_t n);
  /// One of the given values, of which there must be some.
  template <class Value>
  Value one_of(const std::vector<Value>& values) {
    return values[index(values.size())];
  }
  /// The place of one of the weights, as likely as its share of their sum.
  std::size_t weighted(const std::vector<double>& weights);

 private:
  std::mt19937_64 bits_;
};

}  // namespace fretval
