#pragma once

#include <string>
#include <vector>

#include "comparison/report/drawing/plots.h"
#include "comparison/results/results_folder.h"

namespace fretval {

struct Figure {
  Plot plot;
  std::string caption;
};

/// The figures as a filling of the template `figures`.
Filling filling_of(const std::vector<Figure>& figures);

/// Stick radius over the phase, one plot per indenter shape and criterion: MDR as lines, finite elements as points, one
/// colour per k = 3 mu Dd / (2 u_x0), in the paper's normalisation (figure 3). Results swept over the phase only.
std::vector<Figure> stick_radius_figures(const std::vector<StoredResult>& results);

/// (c_FE - c_MDR)/a over the phase, with the tolerance, for the same results.
std::vector<Figure> difference_figures(const std::vector<StoredResult>& results);

/// Limiting profiles over the radius, one plot per indenter shape, with a_inf marked (figure 4), and what the finite
/// elements find on them. Results swept over the worn stick radius only.
std::vector<Figure> limiting_profile_figures(const std::vector<StoredResult>& results);

/// Heights over the radius, a column of a CSV file of a result. length, depth: the units of the plot; look: all but the
/// points.
Series curve_from(const StoredResult& result, const char* file, const std::string& column, double length, double depth,
                  const Series& look);

/// A list of the course of a wear (results/wear_json.h) over its cycles, in a unit; from the second point on, for a
/// logarithm of the cycles.
Series over_cycles(const Filling& wear, const char* key, double unit, const Series& look);

}  // namespace fretval
