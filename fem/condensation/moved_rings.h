#pragma once

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// The compliance of the same body under rings that are wider by a factor near 1. Seen in lengths of these rings it is
/// the body that is smaller by the factor: what the rings do to each other over a half-space stays, and the smooth
/// kernel K that the end of the body adds, of the dimension 1/length, is `factor K(factor r, factor r')` in the place
/// of `K(r, r')`, over ring i and j times their areas. K is taken from the same body under coarse rings: the matrix of
/// `coarse` less that of its half-space, over the areas, at the mean squares of their radii; it is even in both radii.
/// coarse: of equal rings, of which its half-space has as many at least. Throws std::invalid_argument for another one,
/// or for fewer rings than the six that polynomials go through.
Compliance moved_rings(const Compliance& compliance, const Compliance& coarse, double factor);

}  // namespace fretval::fem
