#pragma once

#include <Eigen/Core>
#include <optional>

#include "mdr/layer/coupled_bed.h"

namespace fretval::mdr {

/// One direction of one time step: the loads that coupled springs bear when the indenter arrives at y,
///
///   stretch_j q_j = value_j + slope_j y - coupling(q)_j,   kept between lower_j and upper_j
///
/// which is unilateral contact with 0 and infinity, and friction with +-mu p. Both are the minimum of a convex energy,
/// and have one solution.
///
/// A contact ends somewhere within the width of a spring, where the load on the right falls through the lower limit.
/// Over that width it is a line; the mean of what is above the limit is more than what its middle has, and that is the
/// rim load of the spring: (fall/2 - |w|)^2/(2 fall) for w in the middle, |w| < fall/2. With it neither the sum of the
/// loads nor their coupling depends, in second order, on where in a spring the contact ends.
struct RowProblem {
  Eigen::ArrayXd value, slope, stretch;                      ///< m, 1, 1; stretch at least 1
  Eigen::ArrayXd lower, upper;                               ///< m
  Eigen::ArrayXd fall = Eigen::ArrayXd::Zero(value.size());  ///< over the width of each spring, m; 0: no rim loads
};

struct RowSolution {
  Eigen::ArrayXd load;      ///< m
  Eigen::ArrayXd rim_load;  ///< m, in addition; see RowProblem
  Eigen::ArrayXd coupling;  ///< of both, m
  double y;                 ///< m
};

/// Semismooth Newton on what the modes of the coupling bear, from the loads of a step before: a linear solve of so many
/// unknowns per change of the springs that are at a limit, 2 or 3 of them; with y also where sum(load + rim_load) is
/// prescribed instead of it. guess: y, or where it is looked for. Throws std::runtime_error where the loads were not
/// found, std::invalid_argument for a sum that no y gives.
RowSolution solve_row(const LayerModes& modes, const RowProblem& problem, const Eigen::ArrayXd& before, double guess,
                      std::optional<double> sum = {});

}  // namespace fretval::mdr
