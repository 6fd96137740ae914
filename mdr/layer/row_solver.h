#pragma once

#include <Eigen/Core>
#include <optional>

#include "mdr/layer/coupled_bed.h"
#include "mdr/layer/mode_equations.h"

namespace fretval::mdr {

/// One direction of one time step: the loads that coupled springs bear when the indenter arrives at y,
///
///   stretch_j q_j = value_j + slope_j y - coupling(q)_j,   kept between lower_j and upper_j
///
/// which is unilateral contact with 0 and infinity, and friction with +-mu p. Contact and friction both minimise a
/// convex energy, and have one solution.
///
/// A contact ends somewhere within the width of a spring, where the load on the right falls through the lower limit.
/// Over that width the load is a line. The mean of its part above the limit exceeds the value in the middle of the
/// spring, and the excess is the rim load of the spring: (fall/2 - |w|)^2/(2 fall) for w in the middle, |w| < fall/2.
/// With it neither the sum of the loads nor their coupling depends, in second order, on where in a spring the contact
/// ends. Beyond the edge of a contact with memory the right falls more steeply, as what is not yet in contact would be
/// pressed by all branches: there |w| is a shorter way, and the rim load is fall/beyond (beyond/2 - |w|)^2/(2 beyond).
struct RowProblem {
  Eigen::ArrayXd value, slope, stretch;                      ///< m, 1, 1; stretch at least 1
  Eigen::ArrayXd lower, upper;                               ///< m
  Eigen::ArrayXd fall = Eigen::ArrayXd::Zero(value.size());  ///< over the width of each spring, m; 0: no rim loads
  Eigen::ArrayXd beyond = fall;                              ///< where the right is below the lower limit, m
};

struct RowSolution {
  Eigen::ArrayXd load;      ///< m
  Eigen::ArrayXd rim_load;  ///< m, in addition; see RowProblem
  Eigen::ArrayXd coupling;  ///< of load and rim_load, m
  double y;                 ///< m
};

/// Solves rows by a semismooth Newton method in the amplitudes of the modes, which starts from the loads of the step
/// before: one linear solve, with as many unknowns as modes, for each change of the set of springs at a limit, mostly 2
/// or 3. What it has factored for one row serves the next (ModeEquations).
class RowSolver {
 public:
  explicit RowSolver(const LayerModes& modes);  ///< which outlive the solver

  /// sum: sum(load + rim_load) in m, prescribed instead of y; empty: y is guess. guess: y, or where the search for it
  /// starts. Throws std::runtime_error where the loads were not found, std::invalid_argument for a sum that no y gives.
  RowSolution solve(const RowProblem& problem, const Eigen::ArrayXd& before, double guess,
                    std::optional<double> sum = {});

 private:
  RowSolution bracketed(const RowProblem& problem, const Eigen::ArrayXd& before, double guess, double sum);

  const LayerModes& modes_;
  ModeEquations equations_;
};

}  // namespace fretval::mdr
