#pragma once

#include <vector>

#include "comparison/report/drawing/figures.h"
#include "comparison/results/results_folder.h"

namespace fretval {

/// Figures of a trace that was aligned: as it was recorded, the profile made of it, and the residuals of the trace.
/// Empty: the case has no trace.
std::vector<Figure> trace_figures(const StoredResult& result);

/// Measured points of a force over a displacement, or over time from the beginning of a period; empty if they were not
/// measured. x, y: columns that the axes of the plot show.
std::vector<Series> measured_series(const StoredResult& result, const std::string& x, const std::string& y,
                                    double x_factor, double y_factor);

}  // namespace fretval
