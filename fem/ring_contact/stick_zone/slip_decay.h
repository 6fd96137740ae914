#pragma once

#include <optional>
#include <vector>

#include "fem/history/friction_history.h"

namespace fretval::fem {

/// Largest slip of the innermost n_inside rings in each period that was computed, over the amplitude: how slip dies out
/// in a zone that shakes down. Empty: no such ring, or no tangential motion.
std::vector<double> slip_decay(const FrictionHistory& history, Eigen::Index n_inside);

/// How the surface slips between the last ring of a stick zone and its radius: like that ring, or growing on as from
/// the one before to it.
enum class SlipBeyond { constant, linear };

/// The mean slip of periods inside a stick radius c in or beyond the last of these rings, over its area.
std::vector<double> mean_slip_of_periods(const FrictionHistory& history, const Eigen::VectorXd& areas,
                                         Eigen::Index n_inside, double stick_radius, SlipBeyond beyond);

/// A factor per period, and how far the last ones still differ.
struct DecayFactor {
  double factor, uncertainty;
};

/// The factor by which that falls from one period to the next in the end, from the last two pairs of plain periods in
/// which it fell and is no roundoff. As long as slip takes a while, the factor is off by the root of its size, so what
/// is still to come is the last change over 1/sqrt(factor) - 1, which is the uncertainty. n_ramp: first periods, in
/// which the amplitudes rise. Empty: fewer periods, slip that does not die out so, or a history that jumped to its
/// periodic state.
std::optional<DecayFactor> decay_factor(const FrictionHistory& history, Eigen::Index n_inside, int n_ramp);

}  // namespace fretval::fem
