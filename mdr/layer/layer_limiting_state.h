#pragma once

#include <optional>

#include "mdr/layer/layer_contact.h"
#include "mdr/rheology/rheology.h"
#include "mdr/stick/limiting_state.h"

namespace fretval::mdr {

/// The worn contact of a rig on a layer, which is a disc of radius c at all times: limiting_state() of
/// mdr/stick/limiting_state.h.
///
/// The disc bears the unworn contact of radius c, whose load ends with nothing at its edge, and a flat punch for the
/// rest. So at its edge, where it slips first, only punches are left, and what was one line over a half-space is one:
///
///   D(c) = d0 - (M+ + M-)/2 for shakedown, d0 - max(M+, M-) for first slip
///   M+- = rho |beta A e^(i phi0) -+ Delta d|,   A = u_x0/(mu E*/G*),   beta = e_T(c)/e_N(c)
///
/// D(c): indentation of the unworn layer contact of radius c, in the place of g(c); e: load at the edge of a punch that
/// moves by 1, tangentially and normally (LayerPunch::edge); beta = 1 over a half-space. With the stiffnesses S_N and
/// S_T of the punches at G0 a force stands for its displacement over S, so that under both forces
///
///   F(c) = F0 - (1/2)(|gamma F_x0/mu e^(i phase) - Delta F| + |gamma F_x0/mu e^(i phase) + Delta F|),
///   gamma = beta (G*/E*) S_N/S_T, with F(c) the force of the unworn layer contact of radius c.
///
/// Where several radii fulfil the condition, the largest is taken, as wear shrinks the contact from outside; it is
/// looked for inwards from the radius of the unworn contact at rest, in 64 steps. Where the unworn contact sticks
/// within a smaller radius, wear has taken more before (theory.md). Empty: no radius fulfils the condition. Relative
/// accuracy 1e-11. Throws as limiting_state(), and for a frictionless base.
std::optional<LimitingState> layer_limiting_state(const Profile& profile, const Layer& layer, const Rheology& body,
                                                  double mu, const FrettingControl& control, StickCriterion criterion);

/// beta(c) and gamma(c) of limiting discs of radius c, see layer_limiting_state().
struct EdgeRatios {
  double beta, gamma;
};
EdgeRatios edge_ratios(const Layer& layer, double radius);

}  // namespace fretval::mdr
