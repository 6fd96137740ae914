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

SuiteCheck memory_check(const std::vector<MemorySample>& samples) {
  const std::size_t n = samples.size();
  if (n < fewest_samples) return {"memory", "too few cases to judge", ""};
  const double start = median_bytes(samples, n / 4, n / 2), end = median_bytes(samples, n - n / 4, n);
  const auto n_cases = static_cast<double>(samples.back().n_cases) / 2;  // from the middle of the one to the other's
  return {"memory",
          fmt::format("{:.1f} MB in the second quarter, {:.1f} MB in the last, {:.0f} bytes per case", start / 1e6,
                      end / 1e6, (end - start) / n_cases),
          end - start <= most_growth ? "" : "it grows"};
}

}  // namespace fretval
