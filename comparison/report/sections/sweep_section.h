#pragma once

#include <vector>

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Section about families of cases over any swept entry: both stick radii and what else is compared, with error bars.
/// Phases under the indenters of the paper and worn profiles have sections of their own. Null if there is none.
Filling sweeps_section(const std::vector<StoredResult>& results);

/// Writes sweep.csv beside the folders of the cases of each family: the value of the entry, then each quantity by MDR,
/// by finite elements, and its error bar, in SI units; empty where there is no value.
void write_sweeps(const std::vector<StoredResult>& results);

}  // namespace fretval
