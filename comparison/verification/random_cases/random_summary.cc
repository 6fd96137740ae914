#include "comparison/verification/random_cases/random_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "comparison/support/quantile.h"

namespace fretval {
namespace {

constexpr double most_growth = 16e6;  // bytes
constexpr std::size_t fewest_batches = 8, n_worst = 10;
constexpr double wide_bar = 1e-2, very_wide_bar = 1e-1;

double share_of(std::size_t n, std::size_t all) {
  return all == 0 ? 0 : static_cast<double>(n) / static_cast<double>(all);
}

SoakDistribution distribution_of(const SoakRun& run, std::size_t q) {
  SoakDistribution found;
  found.quantity = soak_quantities[q];
  std::vector<double> errors, bars, effectivities;
  std::size_t n_wide = 0, n_very_wide = 0;
  for (const auto& record : run.records) {
    if (!record.errors[q]) continue;
    const auto& e = *record.errors[q];
    ++found.n;
    if (e.covered()) ++found.n_covered;
    if (e.bar > wide_bar) ++n_wide;
    if (e.bar > very_wide_bar) ++n_very_wide;
    errors.push_back(std::abs(e.error()));
    if (!std::isfinite(e.bar)) {
      ++found.n_unbounded;
      continue;
    }
    bars.push_back(e.bar);
    if (e.error() != 0) effectivities.push_back(e.bar / std::abs(e.error()));
  }
  found.median_error = quantile(errors, 0.5);
  found.high_error = quantile(errors, 0.9);
  found.median_bar = quantile(bars, 0.5);
  found.high_bar = quantile(bars, 0.9);
  found.wide = share_of(n_wide, found.n);
  found.very_wide = share_of(n_very_wide, found.n);
  found.low_effectivity = quantile(effectivities, 0.1);
  found.median_effectivity = quantile(effectivities, 0.5);
  return found;
}

bool fails_otherwise(const SoakRecord& record) {
  const auto worst = record.worst();
  return !failure_of(record).empty() && (!worst || !record.failure.empty() || !record.errors[*worst]->is_finite());
}

double badness(const SoakRecord& record) {
  if (fails_otherwise(record)) return std::numeric_limits<double>::infinity();
  return record.errors[*record.worst()]->share();
}

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
  if (n < fewest_batches) return std::nullopt;
  return MemoryGrowth{median_bytes(samples, n / 4, n / 2), median_bytes(samples, n - n / 4, n),
                      samples.back().n_cases / 2};
}

bool SoakSummary::passes() const {
  return n_failures == 0 && n_above_bar == 0 && (!memory || memory->is_flat());
}

SoakSummary summary_of(const SoakRun& run) {
  SoakSummary summary;
  summary.n_cases = run.records.size();
  for (std::size_t q = 0; q < soak_quantities.size(); ++q) {
    summary.distributions.push_back(distribution_of(run, q));
    summary.n_comparisons += summary.distributions.back().n;
    summary.n_above_bar += summary.distributions.back().n - summary.distributions.back().n_covered;
  }
  for (const auto& record : run.records) {
    if (fails_otherwise(record)) ++summary.n_failures;
    if (!record.refusal.empty()) ++summary.n_drawn_again;
    summary.worst.push_back(&record);
  }
  summary.memory = memory_growth(run.memory);
  const auto end = summary.worst.begin() + static_cast<std::ptrdiff_t>(std::min(n_worst, summary.worst.size()));
  std::partial_sort(summary.worst.begin(), end, summary.worst.end(),
                    [](const auto* a, const auto* b) { return badness(*a) > badness(*b); });
  summary.worst.erase(end, summary.worst.end());
  return summary;
}

std::string scene_text(const SoakRecord& record) {
  const auto entries = soak_entries(record.draw);
  return fmt::format("{}{}, {}, phase {}", entries.count("Wear / State") > 0 ? "worn " : "",
                     entries.at("Indenter / Shape"), entries.at("Elastomer / Rheology"), entries.at("Motion / Phase"));
}

}  // namespace fretval
