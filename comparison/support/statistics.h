#pragma once

#include <optional>
#include <vector>

namespace fretval {

/// The value that a share of the values, 0 to 1, does not exceed (nearest rank); empty for none.
std::optional<double> quantile(std::vector<double> values, double share);

/// A power law fitted to points.
struct LogSlope {
  double slope;
  int n_points;  ///< number of points of the fit; with two of them nothing confirms it
};

/// Slope of log y over log x by least squares, over the points with x > 0 and y > floor; empty if there are fewer than
/// two different x.
std::optional<LogSlope> log_slope(const std::vector<double>& x, const std::vector<double>& y, double floor);

}  // namespace fretval
