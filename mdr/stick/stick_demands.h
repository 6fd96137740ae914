#pragma once

namespace fretval::mdr {

/// Largest excess of the tangential demand over the normal oscillation of an element, M+- = sup_t(+-T - N), for pulls
/// in the two directions: the element needs that much relaxed compression to stick from rest. In the unit of the
/// amplitudes of T and N, which are both not negative (unchecked).
struct StickDemands {
  double forward;   ///< M+
  double backward;  ///< M-
};

/// Equal frequencies, T ahead of N by phase in rad: M+- = |T e^(i phase) -+ N|.
StickDemands locked_demands(double tangential, double normal, double phase);

/// Phase unlocked: M+ = M- = T + N.
StickDemands unlocked_demands(double tangential, double normal);

/// max(M+, M-), against slip of an element that has never slipped.
double first_slip_demand(const StickDemands& demands);

/// (M+ + M-)/2, once the most favourable tangential force is locked in.
double shakedown_demand(const StickDemands& demands);

}  // namespace fretval::mdr
