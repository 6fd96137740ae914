#pragma once

#include <cstddef>
#include <vector>

namespace fretval::mdr {

/// Two signals of a rig over time, of the same length; any units.
struct Record {
  std::vector<double> time;  ///< rising
  std::vector<double> normal, tangential;
};

/// Standard deviation of the white noise of equally spaced samples, from the median of their second differences: exact
/// to some percent for noise alone, and close to nothing where samples follow a smooth course. At least 3 samples,
/// otherwise 0.
double white_noise_of(const std::vector<double>& values);

/// A record with fewer rows, linear between them.
struct ReducedRecord {
  Record record;
  double normal_error, tangential_error;  ///< of what was left out, see reduced()
};

/// Keeps the rows that linear interpolation needs to pass all others within a tolerance of each signal (Ramer 1972,
/// Douglas and Peucker 1973), the first, the last, and the extremes of both signals among them, and so also the rows
/// where a signal turns. Where the noise exceeds a quarter of the tolerance, means of neighbouring rows take the place
/// of rows, of as many as make the sum of noise and smoothing least, and the values at the rows that are kept are those
/// of the broken line that is closest to all rows in the least-squares sense. The tolerance is doubled until at most
/// n_most rows are left.
///
/// Errors are the largest distances of the rows from the broken line; where means take the place of rows, three
/// standard deviations of the value at a row that is kept are added.
///
/// Throws std::invalid_argument for less than two rows, for tolerances that are not positive, or n_most < 4.
ReducedRecord reduced(const Record& record, double normal_tolerance, double tangential_tolerance, std::size_t n_most);

}  // namespace fretval::mdr
