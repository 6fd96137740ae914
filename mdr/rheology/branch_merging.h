#pragma once

#include <cstddef>

#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// A Prony body with fewer branches.
struct MergedBody {
  PronyBody body;
  std::size_t n_merged;  ///< branches that have gone
  double error;          ///< largest |G_merged - G|/|G| over the range of frequencies
};

/// Hastens branches that are slower than the range: halves the time of the slowest one, again and again, as long as the
/// complex modulus changes by less than half of the tolerance, so that the periodic state is reached in fewer cycles.
/// Then merges neighbours in time, two at a time, those first that change the complex modulus least, as long as the
/// relative change from the body as it was stays within the tolerance at all frequencies of the range, from the lowest,
/// and at rest, to the highest, in Hz. A merged branch has the sum of moduli and the mean of times weighed with them,
/// so that the viscosity of branches that are much faster than the range is exact, and so is the stiffness of those
/// that are much slower. Faster ones are left out altogether where that is within the tolerance. The modulus at rest
/// stays as it is. Where fewer branches do that have times of their own, equally spaced in log time from the fastest to
/// the slowest one, and moduli that are fitted to the range (non_negative_least_squares): those instead, merged
/// likewise. In order of time.
///
/// Throws std::invalid_argument for a body, a range or a tolerance that is none.
MergedBody merged(const PronyBody& body, double lowest_frequency, double highest_frequency, double tolerance);

}  // namespace fretval::mdr
