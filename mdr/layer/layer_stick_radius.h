#pragma once

#include "mdr/layer/layer_slip.h"
#include "mdr/springs/forced_response.h"
#include "mdr/stick/stick_radius.h"

namespace fretval::mdr {

/// Stick radii of first slip and of shakedown of an elastic layer under an oscillation from rest, in each direction of
/// a displacement or a force.
///
/// At the instants that decide all springs beyond c slip the same way, so that the states there are pushes: D(c, t) of
/// the normal load of that instant (slip_reach) against the displacement, both as depths,
///
///   T = u_x/(mu E*/G*),   M+- = max_t(+-T - D(c, t)),   first slip: max(M+, M-) = 0,   shakedown: M+ + M- = 0
///
/// as D is linear in the normal load and what slip has locked in drops out of the sum M+ + M-. Under a tangential force
/// T = F_x/(2 mu E*), and the load of slip_reach takes the place of D. Over a half-space D = d(t) - g(c), which are the
/// criteria of mdr/stick/stick_radius.h. With an unlocked phase, or frequencies without a common period, the maxima of
/// +-T and of -D are taken separately and added.
///
/// Validity: c stays in contact; motions of which the springs beyond c all slip to one side, and then all to the other
/// (one harmonic a direction; coupled springs, mdr/layer/coupled_history.h, know no such assumption). Relative accuracy
/// 1e-8. Empty: nothing sticks. Throws std::invalid_argument for bad arguments.
StickRadii layer_stick_radii(const Profile& profile, const Layer& layer, double shear_modulus, double mu,
                             const Prescribed& prescribed);

}  // namespace fretval::mdr
