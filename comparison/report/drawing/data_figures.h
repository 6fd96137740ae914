#pragma once

#include <vector>

#include "comparison/report/drawing/figures.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// A trace that was aligned: as it was recorded, the profile that came of it, and what is left of the trace. Empty: the
/// case has none.
std::vector<Figure> trace_figures(const StoredResult& result);

/// What a rig has measured of a force over a displacement, or over time from the beginning of a period, as points;
/// empty if it has not. x: axes of the plot.
std::vector<Series> measured_series(const StoredResult& result, const std::string& x, const std::string& y,
                                    double x_factor, double y_factor);

}  // namespace fretval
