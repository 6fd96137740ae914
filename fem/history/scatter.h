#pragma once

#include "fem/support/constants.h"

namespace fretval::fem {

/// Tells when tractions change from period to period by nothing but scatter. A reading of a force jumps by a little
/// where a ring changes its state, so that a prescribed force may balance at more than one displacement, and not in
/// every period at the same one. Then the traction of a ring at an instant goes on changing for ever, in turns of a few
/// periods. A change counts as scatter if it is below 1e-2 of the largest traction and has not fallen for 10 periods.
class Scatter {
 public:
  /// change: of tractions in a period over the largest one, one period after the other.
  bool is_all(double change);

 private:
  double least_ = infinity;
  int periods_since_least_ = 0;
};

}  // namespace fretval::fem
