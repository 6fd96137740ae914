#pragma once

#include <optional>
#include <vector>

#include "fem/history/friction_history.h"

namespace fretval::fem {

/// Largest slip of the innermost n_inside rings in each period that was computed, over the amplitude: how slip dies out
/// in a zone that shakes down. Empty: no such ring, or no tangential motion.
std::vector<double> slip_decay(const FrictionHistory& history, Eigen::Index n_inside);

/// How the surface slips between the last ring of a stick zone and the stick radius: like that ring, or growing on
/// linearly from the last two rings.
enum class SlipBeyond { constant, linear };

/// Mean slip over the area inside a stick radius c in each period that was computed, over the amplitude; c lies in or
/// beyond the last of the n_inside innermost rings. Empty: as of slip_decay.
std::vector<double> mean_slip_of_periods(const FrictionHistory& history, const Eigen::VectorXd& areas,
                                         Eigen::Index n_inside, double stick_radius, SlipBeyond beyond);

/// A factor per period, and its uncertainty.
struct DecayFactor {
  double factor, uncertainty;
};

/// The factor by which slip_decay() falls from one period to the next in the end, from the last two pairs of plain
/// periods in which it fell and is no roundoff. As long as a slip takes some time, the factor has an error in
/// proportion to the root of the slip, so that the change still to come is the last change over 1/sqrt(factor) - 1,
/// which is taken for the uncertainty. n_ramp: first periods, in which the amplitudes rise. Empty: too few periods,
/// slip that does not fall by a factor, or a history that jumped to its periodic state.
std::optional<DecayFactor> decay_factor(const FrictionHistory& history, Eigen::Index n_inside, int n_ramp);

}  // namespace fretval::fem
