#include "comparison/support/random_numbers.h"

#include <cmath>
#include <numeric>

namespace fretval {
namespace {

std::mt19937_64 seeded(const std::vector<std::uint64_t>& seeds) {
  std::seed_seq sequence(seeds.begin(), seeds.end());
  return std::mt19937_64(sequence);
}

}  // namespace

RandomNumbers::RandomNumbers(const std::vector<std::uint64_t>& seeds) : bits_(seeded(seeds)) {}

double RandomNumbers::uniform(double from, double to) {
  const double unit = std::ldexp(static_cast<double>(bits_() >> 11U), -53);
  return from + (to - from) * unit;
}

double RandomNumbers::log_uniform(double from, double to) {
  return from * std::exp(uniform(0, std::log(to / from)));
}

bool RandomNumbers::chance(double probability) {
  return uniform(0, 1) < probability;
}

std::size_t RandomNumbers::index(std::size_t n) {
  return static_cast<std::size_t>(uniform(0, static_cast<double>(n)));
}

std::size_t RandomNumbers::weighted(const std::vector<double>& weights) {
  double left = uniform(0, std::accumulate(weights.begin(), weights.end(), 0.0));
  std::size_t k = 0;
  while (k + 1 < weights.size() && left >= weights[k]) left -= weights[k++];
  return k;
}

}  // namespace fretval
