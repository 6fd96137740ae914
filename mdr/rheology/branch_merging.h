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

/// A body with fewer branches for a range of frequencies from the lowest to the highest in Hz. Branches that are slower
/// than the range are hastened: the time of the slowest one is halved, again and again, as long as the complex modulus
/// changes by less than half of the tolerance, so that the periodic state is reached in fewer cycles. After that,
/// branches that are neighbours in time are merged, two at a time, those first that change the complex modulus least,
/// as long as the relative change from the original body stays within the tolerance at rest and at all frequencies of
/// the range. A merged branch has the sum of moduli and the mean of times weighed with them, so that the viscosity of
/// branches that are much faster than the range is exact, and so is the stiffness of those that are much slower.
/// Branches faster than the range are left out altogether where that is within the tolerance. The modulus at rest stays
/// as it is. Where fewer branches suffice whose times are equally spaced in log time from the fastest to the slowest
/// one and whose moduli are fitted to the range (non_negative_least_squares), those are taken instead, and merged by
/// the same rule. The branches of the result are in the order of their times.
///
/// Throws std::invalid_argument for a bad body, range or tolerance.
MergedBody merged(const PronyBody& body, double lowest_frequency, double highest_frequency, double tolerance);

}  // namespace fretval::mdr
