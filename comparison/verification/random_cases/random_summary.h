#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/verification/random_cases/random_suite.h"

namespace fretval {

/// How one quantity came out over all cases; quantiles over the finite bars. Units of SoakError.
struct SoakDistribution {
  std::string quantity;
  std::size_t n = 0, n_covered = 0;
  std::size_t n_unbounded = 0;                     ///< bars that are infinite
  std::optional<double> median_error, high_error;  ///< 50 and 90 % are below
  std::optional<double> median_bar, high_bar;
  double wide = 0, very_wide = 0;                             ///< shares of bars above 1e-2 and above 1e-1
  std::optional<double> low_effectivity, median_effectivity;  ///< bar over error; 10 and 50 % are below
};

/// Resident memory from the second quarter of a run, when everything that is made once is there, to the last one: the
/// medians of both, so that a single batch does not decide.
struct MemoryGrowth {
  double start, end;    ///< bytes
  std::size_t n_cases;  ///< from the middle of the one quarter to the middle of the other

  [[nodiscard]] double bytes_per_case() const;
  /// At most 16 MB more at the end.
  [[nodiscard]] bool is_flat() const;
};

/// Empty for less than eight batches, which tell nothing.
std::optional<MemoryGrowth> memory_growth(const std::vector<MemorySample>& samples);

struct SoakSummary {
  std::size_t n_cases = 0, n_comparisons = 0;
  std::size_t n_failures = 0;     ///< cases that fail otherwise than by an error above its bar
  std::size_t n_above_bar = 0;    ///< comparisons
  std::size_t n_drawn_again = 0;  ///< cases
  std::vector<SoakDistribution> distributions;
  std::optional<MemoryGrowth> memory;
  std::vector<const SoakRecord*> worst;  ///< at most ten: failures first, then by the largest share of a bar

  /// No failure, no error above its bar, memory flat or not judged.
  [[nodiscard]] bool passes() const;
};

/// The run must outlive the summary.
SoakSummary summary_of(const SoakRun& run);

/// "parabola, kelvin voigt, phase 30"
std::string scene_text(const SoakRecord& record);

}  // namespace fretval
