#pragma once

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// For the template `table`: what a rig has measured beside both methods, and how they differ from it; null: nothing
/// was measured.
Filling measured_table(const StoredResult& result);

/// How the data of a case were processed, in a sentence for each; null: they were taken as they are.
Filling data_sentences(const StoredResult& result);

}  // namespace fretval
