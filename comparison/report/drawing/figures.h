#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparison/quantities/plane_edges.h"
#include "comparison/report/drawing/plots.h"
#include "comparison/report/text/filling.h"
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

/// A list of the course of a wear (results/case_result.h) over its cycles, in a unit; from the second point on, for a
/// logarithm of the cycles.
Series over_cycles(const Filling& wear, const char* key, double unit, const Series& look);

/// The cycle.json of a case; an empty object if it is not there. Throws InputError if it is no JSON.
nlohmann::ordered_json read_cycle(const StoredResult& result);

/// For the template `figures`: what happens under the indenter in the last period, loops of both forces, slip,
/// profiles, and what makes up the error bars; as far as the files of the case are there.
Filling case_figures(const StoredResult& result, const nlohmann::ordered_json& cycle);

/// Figures of a trace that was aligned: as it was recorded, the profile made of it, and the residuals of the trace.
/// Empty: the case has no trace.
std::vector<Figure> trace_figures(const StoredResult& result);

/// Measured points of a force over a displacement, or over time from the beginning of a period; empty if they were not
/// measured. x, y: columns that the axes of the plot show.
std::vector<Series> measured_series(const StoredResult& result, const std::string& x, const std::string& y,
                                    double x_factor, double y_factor);

/// Storage and loss modulus of the body over frequency, from moduli.csv; with the points of measured moduli, and how
/// well the body fits them.
Figure moduli_figure(const StoredResult& result);

/// Radii of the zones by MDR, m; empty: MDR has none.
struct MdrRadii {
  std::optional<double> contact, never_slipped, sticks_in_a_cycle;
};

/// The contact from above: edges of the contact and of the zones that have never slipped and that stick in a cycle,
/// beside circles of MDR's radii.
Figure edges_figure(const PlaneEdges& edges, const MdrRadii& mdr);

/// The contact from above at the end of the last cycle of a contact on rings and angles: edges of the contact and of
/// the zones that have never slipped and that stick in a cycle, and the traction on the body as arrows. Drawn from the
/// files zones.csv and surface.csv of a case.
Figure plane_figure(const StoredResult& result);

/// For the template `sketch`: the indenter at its largest indentation and the surface of the finite elements, to one
/// scale in both directions, with the zones that stick and slip. Null without the files of a case.
Filling sketch_of(const StoredResult& result);

}  // namespace fretval
