#pragma once

#include <string>
#include <vector>

#include "comparison/accuracy/error_budget.h"
#include "comparison/case/case.h"
#include "comparison/reference/mdr_case.h"

namespace fretval {

/// A case with one of its data off by what is known of its error.
struct DataVariant {
  std::string what;         ///< is off, for people
  std::vector<Case> cases;  ///< of which the farthest counts
};

/// A trace that is aligned otherwise, by two standard deviations; a path that is off by what was left out of the
/// record, and by how its cycles scatter; moduli that scatter about a hardness; a body that is fitted to G' alone where
/// G' and G'' contradict each other, so that no body has both. Empty: the data are taken as they are.
std::vector<DataVariant> data_variants(const Case& input);

/// By how much MDR's answer changes with the data, over the scale of each quantity; the variants add up. MDR stands for
/// both methods here: what they differ in changes less with the data than what they agree in.
Quantities data_uncertainties(const Case& input, const MdrCase& mdr);

/// Adds them to the bars that there are.
void add_data_shares(const Case& input, const MdrCase& mdr, ErrorBudget& budget);

}  // namespace fretval
