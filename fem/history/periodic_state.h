#pragma once

#include <Eigen/Dense>
#include <functional>
#include <utility>
#include <vector>

#include "fem/condensation/compliance.h"
#include "fem/motion/relaxation.h"

namespace fretval::fem {

/// How a contact was in a step, as far as its next states depend on the last ones.
struct FrozenStep {
  RelaxationStep relaxation;
  std::vector<bool> held;  ///< per ring: sticks, or is in contact
};

/// A period of a contact from some state on.
struct FrozenPeriod {
  RingState end;
  std::vector<FrozenStep> steps;
};

/// What a ring that is held does to a small change of its displacement: one that sticks goes on with it, one in contact
/// goes back to the surface of the indenter.
enum class Hold { sticks, closes };

/// How far the state at the start of a period is from that which repeats, if every ring is held in the same steps as in
/// the period: then the state at its end is affine in that at its start, F(x + dx) = F(x) + J dx, and
///
///   x* - x = (1 - J)^-1 (F(x) - x)
///
/// exactly, however slowly the body creeps. Rings that are held in all steps keep their displacement, wherever slip has
/// locked it in, and their memory goes on by itself, to change/(1 - exp(-period/tau)); all others make a dense system
/// of n_moving (1 + n_branches), with the compliance that is left of them while the former are held. What the memory
/// of the former does to the others is left out: it settles at once.
/// change: F(x) - x.
RingState correction_to_periodic(const Compliance& compliance, const std::vector<FrozenStep>& steps, Hold hold,
                                 const RingState& change);

struct PeriodicState {
  RingState state;
  /// What the response of a ring, relaxed displacement plus memories, is still away from that of the periodic state,
  /// over the largest of all: by the last correction. Infinite: none was found.
  double to_come;
  int n_periods;  ///< computed on the way
};

/// Newton's method for the state x = F(x) that a period leads back to: F is piecewise affine, and its pieces are the
/// rings that are held in each step. Ends where the response to a correction is below the tolerance, also that of rings
/// that are held at once or, where roundoff keeps that from falling, of all others; or after some periods with the best
/// state so far. period: computed from a state on.
PeriodicState find_periodic_state(const Compliance& compliance, const RelaxationModel& relaxation, Hold hold,
                                  RingState start, double tolerance,
                                  const std::function<FrozenPeriod(const RingState&)>& period);

/// The period of a copy of a contact that is put into a state; step: takes it on by one.
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
