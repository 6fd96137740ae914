#pragma once

namespace fretval::fem {

/// A radius, dimensionless, and its uncertainty from the width of the rings; the errors of the time steps and of a
/// motion that is not periodic yet are not in it.
struct EdgeRadius {
  double radius;
  double uncertainty;
};

}  // namespace fretval::fem
