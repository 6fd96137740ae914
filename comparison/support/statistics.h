#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace fretval {

/// The value that a share of the values, 0 to 1, does not exceed (nearest rank); empty for none.
std::optional<double> quantile(std::vector<double> values, double share);

/// The largest absolute value; 0 for none.
double largest_size(const std::vector<double>& values);

/// The largest value less the smallest of one or more.
double range_of(const std::vector<double>& values);

/// Some of the values at equal distances, as many as possible but at most so many, for drawings.
std::vector<double> thinned(const std::vector<double>& values, std::size_t most);

/// The number with so many significant digits.
double to_digits(double value, int digits);

/// A power law fitted to points.
struct LogSlope {
  double slope;
  int n_points;  ///< number of points of the fit; with two of them nothing confirms it
};

/// Slope of log y over log x by least squares, over the points with x > 0 and y > floor; empty if there are fewer than
/// two different x.
std::optional<LogSlope> log_slope(const std::vector<double>& x, const std::vector<double>& y, double floor);

/// Mean slip in a cycle, over the tangential amplitude, below which a zone counts as shaken down; the same as for a
/// ring that counts as stuck (fem::slip_of_stuck_ring).
constexpr double slip_that_counts_as_none = 1e-4;

/// After how many cycles slip has died out: the time, in cycles from the beginning of the first one, at which straight
/// lines between the slips of cycles n = 1, 2, ... cross `least` for the last time. Empty: the slip is never above it,
/// or still is.
std::optional<double> cycles_until(const std::vector<double>& slips, double least);

}  // namespace fretval
