#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "comparison/verification/suite.h"

namespace fretval {

/// Errors and bars of one quantity over all cases with one tolerance.
struct QuantitySummary {
  std::size_t n = 0;
  std::size_t n_above = 0;                 ///< errors that are above their bar, see ComparedQuantity::share
  std::size_t n_wide = 0;                  ///< bars that are wider than the tolerance
  std::vector<double> errors = {};         ///< finite |error|
  std::vector<double> bars = {};           ///< finite error bars
  std::vector<double> effectivities = {};  ///< bar over error, where both are finite and the error is not zero
};

/// Summaries by quantity and tolerance.
using QuantitySummaries = std::map<std::pair<Quantity, double>, QuantitySummary>;
QuantitySummaries quantity_summaries(const std::vector<SuiteRow>& rows);

/// Number of rows with a verdict.
std::size_t count(const std::vector<SuiteRow>& rows, RowVerdict verdict);

/// The quantity with the largest share of its bar; null: nothing was compared.
const ComparedQuantities::value_type* worst_of(const SuiteRow& row);

/// The rows that tables and JSON show: all rows of a suite that is small enough to be read, otherwise the worst ten and
/// every row that fails. Failing rows come first then, the others by the largest share of a bar.
std::vector<const SuiteRow*> shown_rows(const std::vector<SuiteRow>& rows);
std::vector<const SuiteRow*> worst_rows(const std::vector<SuiteRow>& rows);

/// Remark on a row beside its numbers: why it fails, the message that it is refused with, or which bars are wider than
/// their tolerance.
std::string remark_of(const SuiteRow& row);

}  // namespace fretval
