#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/verification/suite.h"

namespace fretval {

/// Quantiles of a sample: 10, 50 and 90 % of it are not larger. Empty: of nothing.
struct Spread {
  std::optional<double> low, median, high;
};

/// How one quantity came out over all cases that were held to one tolerance.
struct QuantitySummary {
  Quantity quantity;
  double tolerance;
  std::size_t n = 0;
  std::size_t n_above = 0;      ///< errors that are above their bar, see ComparedQuantity::share
  std::size_t n_wide = 0;       ///< bars that are wider than the tolerance
  std::size_t n_unbounded = 0;  ///< of those, infinite ones
  Spread error, bar;            ///< |error|; finite bars
  Spread effectivity;           ///< bar over error, where both are finite and the error is not zero
};

/// By quantity and tolerance.
std::vector<QuantitySummary> quantity_summaries(const std::vector<SuiteRow>& rows);

/// How many rows came to a verdict.
std::size_t count(const std::vector<SuiteRow>& rows, RowVerdict verdict);

/// How many errors there are, and how many of them are above their bars.
struct ErrorCounts {
  std::size_t n = 0, n_above = 0;
};
ErrorCounts count_errors(const std::vector<SuiteRow>& rows);

/// The quantity with the largest share of its bar; null: nothing was compared.
const ComparedQuantities::value_type* worst_of(const SuiteRow& row);

/// The rows that tables and JSON show: all of a suite that is small enough to be read, otherwise the worst ten, with
/// every one that fails. Failing rows come first then, the others by the largest share of a bar.
std::vector<const SuiteRow*> shown_rows(const std::vector<SuiteRow>& rows);
std::vector<const SuiteRow*> worst_rows(const std::vector<SuiteRow>& rows);

/// What is to be said of a row besides its numbers: why it fails, the message that it is refused with, or which bars
/// are wider than their tolerance.
std::string remark_of(const SuiteRow& row);

}  // namespace fretval
