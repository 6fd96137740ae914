#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "comparison/accuracy/compared_quantities.h"
#include "comparison/support/log_slope.h"

namespace fretval {

/// What a setting comes to; NaN: it failed.
struct ErrorAndSeconds {
  double error, seconds;
};

/// Indices of the points for which no other one has both a smaller error and fewer seconds, by rising seconds and
/// falling error. Of points with the same error the fastest counts, of equally fast ones the most accurate, of equal
/// ones the first; errors within 1e-6 of each other are the same. Points that are not finite never count.
std::vector<std::size_t> pareto_front(const std::vector<ErrorAndSeconds>& points);

/// Slope of the errors of a sweep, coarsest first: over those before the first one that is not above the floor.
std::optional<LogSlope> observed_rate(std::vector<double> values, std::vector<double> errors);

/// Whether errors are within a tolerance: T on the stick radii (and on the evidence of a limiting profile), T/10 on
/// contact radius and normal force, as in a verdict.
bool meets(const Quantities& errors, double tolerance);

/// A setting to choose from.
struct Candidate {
  Quantities errors;  ///< empty: it failed
  double seconds;
};

/// Index of the fastest candidate that meets a tolerance; empty: none does.
std::optional<std::size_t> cheapest(const std::vector<Candidate>& candidates, double tolerance);

}  // namespace fretval
