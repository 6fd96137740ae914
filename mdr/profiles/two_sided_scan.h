#pragma once

#include <vector>

namespace fretval::mdr {

/// A scan through the apex, from r < 0 to r > 0, as one profile.
struct MeanOfHalves {
  std::vector<double> r, f;            ///< mean height of both halves at the radii of either, where there are both
  double largest_difference = 0;       ///< between the heights of both halves at one radius, m
  double radius_of_difference = 0;     ///< where that is, m
  [[nodiscard]] double range() const;  ///< of the mean heights, m
};

/// The mean of both halves of a scan, each linear between its rows; a row at r = 0, the apex, belongs to both. Radii
/// that differ by less than 1e-9 of the last one are taken as one.
///
/// r and f in m, as many, r increasing. Throws std::invalid_argument unless both halves have at least two rows and the
/// radii of one reach into those of the other.
MeanOfHalves mean_of_halves(const std::vector<double>& r, const std::vector<double>& f);

/// Throws std::invalid_argument, with the values, if the halves differ by more than 5 % of the range of heights and six
/// standard deviations of the noise (that of a difference is 1.4 of them), in m: the body is not axisymmetric, or r = 0
/// is not its apex.
void require_axisymmetric(const MeanOfHalves& mean, double noise);

}  // namespace fretval::mdr
