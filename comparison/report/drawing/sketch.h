#pragma once

#include "comparison/report/text/filling.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// For the template `sketch`: the indenter at its largest indentation and the surface of the finite elements, to one
/// scale in both directions, with the zones that stick and slip. Null without the files of a case.
Filling sketch_of(const StoredResult& result);

}  // namespace fretval
