#pragma once

#include <functional>

#include "mdr/motion/harmonic_motion.h"
#include "mdr/springs/spring_foundation.h"

namespace fretval::mdr {

/// Normal response to a normal motion of several harmonics, over their common period or that of the RepeatingMotion
/// that stands for them, from time 0 of the motion on. The transient springs (mdr/springs/spring_history.h) are stepped
/// until they repeat; the largest and the smallest force are extrapolated from n and 2 n springs and steps, each of
/// second order, and a third of the difference is the error of the largest: some 1e-6 of it. For arguments and results
/// see periodic_normal_response(), which has no such error but takes one harmonic alone. Throws std::invalid_argument
/// for bad arguments, std::runtime_error when the springs do not become periodic.
NormalResponse stepped_normal_response(const std::function<double(double)>& g, double outer_radius,
                                       const PronyBody& body, const HarmonicMotion& motion);

}  // namespace fretval::mdr
