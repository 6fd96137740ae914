#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/quantities/quantity.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// A quantity of the finite elements in two results of one case.
struct Change {
  std::string name;  ///< of the case
  Quantity quantity;
  std::optional<double> before, after;  ///< SI; empty: nothing sticks, or not computed
  double difference = 0;                ///< in the units of comparison, see Quantities; 1 if only one has the quantity
  double bars = 0;                      ///< sum of both bars, in the units of comparison; 0: not known

  [[nodiscard]] bool is_beyond_bars() const;
};

/// Differences between two folders of results.
struct Changes {
  std::vector<Change> values;
  std::vector<std::string> only_before, only_after;  ///< names of cases
  std::vector<std::string> inputs;                   ///< inputs that differ, "CASE: SECTION / ENTRY: BEFORE -> AFTER"
  /// Cases that passed before and do not now, or the reverse: "case: agree before, now disagree".
  std::map<std::string, std::string> verdicts;

  /// Whether a value has moved beyond its bars, or a verdict has changed.
  [[nodiscard]] bool any() const;
  /// The changes of a case beyond its bars and of its verdict, a line for each; empty: there are none.
  [[nodiscard]] std::string of_case(const std::string& name) const;
};

Changes changes_between(const std::vector<StoredResult>& before, const std::vector<StoredResult>& after);

/// Text on every change beyond its bars, and on the size of the others.
std::string changes_text(const Changes& changes);

}  // namespace fretval
