#pragma once

#include <string>

#include "comparison/report/text/render.h"

namespace fretval {

/// What readers without scripts find in the place of a plot, for the template `plot_table`: its numbers as a table,
/// evenly thinned to some 40 rows; of a picture of a plane or a plot without points a sentence.
Filling plot_table(const Filling& plot);

/// "c_{FE}" and "φ_0" where there are no subscripts: "cFE", "φ0".
std::string without_subscripts(const std::string& text);

}  // namespace fretval
