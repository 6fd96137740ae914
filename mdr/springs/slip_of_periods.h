#pragma once

#include <vector>

#include "mdr/springs/forced_response.h"

namespace fretval::mdr {

/// How slip dies out inside a stick radius c, m, while a motion goes on from rest: of each period the mean path of slip
/// of the surface at r < c, m, until that is at most `least`, m, or the tractions repeat. The surface slips like the
/// springs,
///
///   s(r) = 2/pi int_0^r s_1(x)/sqrt(r^2 - x^2) dx   ->   mean = 4/(pi c^2) int_0^c s_1(x) sqrt(c^2 - x^2) dx,
///
/// as long as all of them slip in one direction; otherwise the mean is an upper bound. All amplitudes rise over n_ramp
/// oscillations of the slowest harmonic. Of the fineness n_springs, steps_per_oscillation and periodicity count. Throws
/// std::invalid_argument for bad arguments and a motion without a common period or a locked phase, std::runtime_error
/// when the springs do not become periodic and for a tangential force that no friction holds.
std::vector<double> slip_of_periods(const Profile& profile, const PronyBody& body, double mu,
                                    const Prescribed& prescribed, double stick_radius, int n_ramp, double least,
                                    const SpringFineness& fineness);

}  // namespace fretval::mdr
