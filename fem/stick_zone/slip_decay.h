#pragma once

#include <vector>

#include "fem/history/friction_history.h"

namespace fretval::fem {

/// Largest slip of the innermost n_inside rings in each period that was computed, over the amplitude: how slip dies out
/// in a zone that shakes down. Empty: no such ring, or no tangential motion.
std::vector<double> slip_decay(const FrictionHistory& history, Eigen::Index n_inside);

}  // namespace fretval::fem
