#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/accuracy/quantity.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// A quantity of the finite elements in two results of one case.
struct Change {
  std::string name;  ///< of the case
  Quantity quantity;
  std::optional<double> before, after;  ///< SI; empty: nothing sticks, or not computed
  double difference = 0;                ///< in the units of comparison, see Quantities; 1 if only one has the quantity
  double bars = 0;                      ///< of both together, likewise; 0: none are known

  [[nodiscard]] bool is_beyond_bars() const;
};

/// What two folders of results have in common, and what not.
struct Changes {
  std::vector<Change> values;
  std::vector<std::string> only_before, only_after;  ///< names of cases
  std::vector<std::string> inputs;                   ///< "CASE: SECTION / ENTRY: BEFORE -> AFTER" of what differs
  std::vector<std::string> verdicts;                 ///< cases that passed before and do not now, or the reverse

  [[nodiscard]] bool any_beyond_bars() const;
  /// What of a case has moved beyond its bars, a line each; empty: nothing has.
  [[nodiscard]] std::string moved(const std::string& name) const;
};

Changes changes_between(const std::vector<StoredResult>& before, const std::vector<StoredResult>& after);

/// For people: every change beyond its bars, and how large the others are.
std::string changes_text(const Changes& changes);

}  // namespace fretval
