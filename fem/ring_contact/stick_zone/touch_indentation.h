#pragma once

#include <Eigen/Dense>

#include "fem/condensation/compliance.h"

namespace fretval::fem {

/// Indentation at which a worn flank comes into contact: rings 0..n_pressed-1 are pressed, and the gap of the n_flank
/// rings after them, averaged over their area, closes. profile: ring means.
double touch_indentation(const Compliance& compliance, const Eigen::VectorXd& profile, Eigen::Index n_pressed,
                         Eigen::Index n_flank);

}  // namespace fretval::fem
