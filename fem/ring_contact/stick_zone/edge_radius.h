#pragma once

namespace fretval::fem {

/// A radius and how far the rings may have put it off: not the error of the time steps or of a motion that is not
/// periodic.
struct EdgeRadius {
  double radius;
  double uncertainty;
};

}  // namespace fretval::fem
