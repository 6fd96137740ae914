#pragma once

#include <functional>
#include <string>
#include <vector>

#include "comparison/simulation/fem_case/units.h"

namespace fretval {

/// Depth that an indenter has lost before, over the radius, dimensionless.
struct WornBefore {
  std::function<double(double)> depth;
  std::vector<double> kinks;  ///< rising radii, between which it is linear
};

/// From a table of heights (columns radius, height), linear in the depth that is worn off, which keeps an indenter
/// unworn where two rows are; halfway from an unworn row to a worn one it begins, as a worn profile is vertical at the
/// stick radius. Beyond the rows it is unworn. Throws InputError for a height below the unworn profile by more than the
/// tolerance.
WornBefore worn_by_heights(const std::string& table, const Units& units, const std::function<double(double)>& profile,
                           double tolerance);

/// From what the rings of an earlier run have lost (columns outer radius, worn depth): the same depth over each ring,
/// so that the volume that these rings have lost is that which others lose, whatever their radii. Throws InputError for
/// radii that do not rise from 0 and for negative depths.
WornBefore worn_by_rings(const std::string& table, const Units& units);

}  // namespace fretval
