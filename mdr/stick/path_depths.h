#pragma once

#include <optional>
#include <vector>

#include "mdr/motion/sampled_path.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/stick/stick_radius.h"
#include "mdr/support/exponential_sum.h"

namespace fretval::mdr {

/// Depths g(c) in m of the edge of the stick zone along a path; not positive: nothing sticks. A single pass has no
/// periodic state, and so no shakedown.
struct PathDepths {
  double first_slip;
  std::optional<double> shakedown;
};

/// The forces of an element that stays in contact and sticks, both divided by 4 G0 per length, T also by mu, are exact
/// sums of exponentials along each piece of the path, of rate v from its row y on:
///
///   N(s) = y + v s + sum_i h_i(s) + (eta/G0) v,   h_i(s) = (G_i/G0) tau_i v + (h_i(0) - (G_i/G0) tau_i v) e^(-s/tau_i)
///
/// with h_i = 0 at the start of a single pass. On a path that repeats h_i(0) is the value of the periodic state: what
/// one period makes of a branch that starts relaxed, over 1 - e^(-period/tau_i). T is the same function of the
/// departure of u_x from rest, times 2/(3 mu). With M+- = sup_t(+-T - N), the element at depth g sticks from rest on
/// iff g <= -max(M+, M-), once the most favourable tangential force is locked in iff g <= -(M+ + M-)/2: the criteria of
/// stick_depths() of mdr/stick/stick_radius.h. Suprema are upper bounds, to 1e-12 of the largest |d|.
///
/// Both depths imply contact at every instant: an element that touches later than at the first row of a pass has not
/// stuck since rest. First slip of a path that repeats supposes that the departure from rest grows slowly from zero. mu
/// positive. Throws std::invalid_argument for bad arguments and for a path that prescribes a force.
PathDepths path_stick_depths(const PronyBody& body, double mu, const SampledPath& path);

/// Stick radii in m of path_stick_depths(); empty: nothing sticks, or no shakedown.
StickRadii stick_radii(const Profile& profile, const PronyBody& body, double mu, const SampledPath& path);

/// N (normal) or T (tangential, departure from rest in m, not scaled by 2/(3 mu)) of each piece, over the time s since
/// its first row.
enum class PathDirection { normal, tangential };
std::vector<ExponentialSum> path_response(const PronyBody& body, const SampledPath& path, PathDirection direction);

}  // namespace fretval::mdr
