#pragma once

#include <Eigen/Dense>
#include <functional>
#include <utility>
#include <vector>

#include "fem/condensation/compliance.h"
#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// A step of a contact, as far as it decides how the next state depends on the last one.
struct FrozenStep {
  RelaxationStep relaxation;
  std::vector<bool> held;  ///< per ring: sticks, or is in contact
};

/// A period of a contact from some state on: its steps, and the state at its end.
struct FrozenPeriod {
  RingState end;
  std::vector<FrozenStep> steps;
};

/// What becomes of a small change of the displacement of a ring that is held: a ring that sticks keeps it, a ring in
/// normal contact goes back to the surface of the indenter.
enum class Hold { sticks, closes };

/// How far the state at the start of a period is from that which repeats, if every ring is held in the same steps as in
/// the period: then the state at its end is affine in that at its start, F(x + dx) = F(x) + J dx, and
///
///   x* - x = (1 - J)^-1 (F(x) - x)
///
/// exactly, however slowly the body creeps. Rings that are held in all steps keep their displacement, wherever slip has
/// locked it in, and their memory settles by itself, by change/(1 - exp(-period/tau)). All other rings make a dense
/// system of n_moving (1 + n_branches) unknowns, with the compliance that they have while the former are held. What the
/// memory of the held rings does to the others is left out. change: F(x) - x.
RingState correction_to_periodic(const Compliance& compliance, const std::vector<FrozenStep>& steps, Hold hold,
                                 const RingState& change);

struct PeriodicState {
  RingState state;
  /// Estimate by the last correction of how far the response of a ring, relaxed displacement plus memories, is from
  /// that of the periodic state, over the largest response. Infinite: no periodic state was found.
  double to_come;
  int n_periods;  ///< computed on the way
};

/// Newton's method for the state x = F(x) that a period leads back to: F is piecewise affine, and its pieces are the
/// rings that are held in each step. It ends where the response to a correction is below the tolerance in all rings or,
/// where roundoff keeps that of the held rings from falling, in all others; or after some periods, with the best state
/// so far. period(state): computes a period from a state on.
PeriodicState find_periodic_state(const Compliance& compliance, const RelaxationModel& relaxation, Hold hold,
                                  RingState start, double tolerance,
                                  const std::function<FrozenPeriod(const RingState&)>& period);

/// The period of a copy of a contact that is put into a state. step(contact): makes its next step.
template <class Contact, class Step>
FrozenPeriod period_from(const RingState& state, Contact contact, int n_steps, const Step& step) {
  FrozenPeriod period;
  contact.state = state;
  for (int k = 0; k < n_steps; ++k) {
    step(contact);
    period.steps.push_back(contact.frozen());
  }
  period.end = std::move(contact.state);
  return period;
}

}  // namespace fretval::fem
