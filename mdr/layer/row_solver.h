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
struct RowProblem {
  Eigen::ArrayXd value, slope, stretch;  ///< m, 1, 1; stretch at least 1
  Eigen::ArrayXd lower, upper;           ///< m
};

struct RowSolution {
  Eigen::ArrayXd load;      ///< m
  Eigen::ArrayXd coupling;  ///< of these loads, m
  double y;                 ///< m
};

/// Semismooth Newton on what the modes of the coupling bear, from the loads of a step before: a linear solve of so many
/// unknowns per change of the springs that are at a limit, 2 or 3 of them; with y also where sum(load) is prescribed
/// instead of it. guess: y, or where it is looked for. Throws std::runtime_error where the loads were not found,
/// std::invalid_argument for a sum that no y gives.
RowSolution solve_row(const LayerModes& modes, const RowProblem& problem, const Eigen::ArrayXd& before, double guess,
                      std::optional<double> sum = {});

}  // namespace fretval::mdr
