#include "comparison/verification/random_cases/memory_watch.h"

#include <fmt/format.h>

#include "comparison/support/quantile.h"

namespace fretval {
namespace {

constexpr double most_growth = 16e6;  // bytes
constexpr std::size_t fewest_samples = 8;

double median_bytes(const std::vector<MemorySample>& samples, std::size_t begin, std::size_t end) {
  std::vector<double> bytes;
  for (std::size_t k = begin; k < end; ++k) bytes.push_back(samples[k].bytes);
  return quantile(bytes, 0.5).value();
}

}  // namespace

double MemoryGrowth::bytes_per_case() const {
  return (end - start) / static_cast<double>(n_cases);
}

bool MemoryGrowth::is_flat() const {
  return end - start <= most_growth;
}

std::optional<MemoryGrowth> memory_growth(const std::vector<MemorySample>& samples) {
  const std::size_t n = samples.size();
  if (n < fewest_samples) return std::nullopt;
  return MemoryGrowth{median_bytes(samples, n / 4, n / 2), median_bytes(samples, n - n / 4, n),
                      samples.back().n_cases / 2};
}

SuiteCheck memory_check(const std::vector<MemorySample>& samples) {
  const auto growth = memory_growth(samples);
  if (!growth) return {"memory", "too few cases to judge", ""};
  return {"memory",
          fmt::format("{:.1f} MB in the second quarter, {:.1f} MB in the last, {:.0f} bytes per case",
                      growth->start / 1e6, growth->end / 1e6, growth->bytes_per_case()),
          growth->is_flat() ? "" : "it grows"};
}

}  // namespace fretval
