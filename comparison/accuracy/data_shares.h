#pragma once

#include <string>
#include <vector>

#include "comparison/accuracy/error_budget.h"
#include "comparison/case/case.h"
#include "comparison/reference/mdr_case.h"

namespace fretval {

/// Cases in which one kind of data of a case is changed by its known error.
struct DataVariant {
  std::string what;         ///< name of the data that are changed, for people
  std::vector<Case> cases;  ///< of these changes the one with the largest effect counts
};

/// The variants of a case for the data whose errors are known: a trace that is aligned differently, by two standard
/// deviations; a path that is off by what was left out of the record, and by the scatter of its cycles; moduli that
/// scatter about those of a hardness; a body that is fitted to G' alone where G' and G'' contradict each other, so that
/// no body has both. Empty: there are no such data.
std::vector<DataVariant> data_variants(const Case& input);

/// Changes of MDR's answer with the data, over the scale of each quantity; the variants add up. MDR stands for both
/// methods here: their difference changes less with the data than their values do.
Quantities data_uncertainties(const Case& input, const MdrCase& mdr);

/// Adds data_uncertainties() as shares to the bars of a budget.
void add_data_shares(const Case& input, const MdrCase& mdr, ErrorBudget& budget);

}  // namespace fretval
