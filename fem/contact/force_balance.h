#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <utility>

#include "fem/support/solver_error.h"

namespace fretval::fem {

/// Where a search for the balance of a force begins.
struct BalanceGuess {
  double displacement;
  double stiffness;  ///< force per displacement around there, roughly; positive
  double scale;      ///< size of the forces, over which accuracy is judged; positive
};

/// The displacement of the indenter at which a force that rises with it has a value: secants, held between the nearest
/// displacements that are known to be too small and too large. Accurate to roundoff of the scale. A reading of a force
/// may jump by a little where a ring changes its state; a value inside the jump is balanced where the jump is. force:
/// as a function of the displacement. Throws SolverError if the force stays on one side of the value.
double displacement_for_force(const std::function<double(double)>& force, double value, const BalanceGuess& guess);

/// displacement_for_force() for a force that is read from what a step makes of a displacement. make(displacement): the
/// step; force_of(step): its force. Returns the displacement and the step that was made of it.
template <class Make, class ForceOf>
auto attempt_for_force(const Make& make, const ForceOf& force_of, double value, const BalanceGuess& guess) {
  std::optional<decltype(make(0.0))> last;
  double at = 0;
  const auto force = [&](double displacement) {
    at = displacement;
    return force_of(last.emplace(make(displacement)));
  };
  const double displacement = displacement_for_force(force, value, guess);
  if (displacement != at) last.emplace(make(displacement));
  return std::pair{displacement, std::move(*last)};
}

/// No displacements were found that balance forces, as where the contact is about to slide.
struct NoBalance : SolverError {
  using SolverError::SolverError;
};

/// Displacements in several directions, and the stiffness of the forces there: `stiffness(i, j) = dF_i/du_j`.
struct BalanceOfForces {
  Eigen::VectorXd displacements;
  Eigen::MatrixXd stiffness;  ///< empty: it is measured by a displacement of `probe` in each direction
};

/// Forces at displacements, each of them known to `within`.
using ForcesAt = std::function<Eigen::VectorXd(const Eigen::VectorXd& displacements, double within)>;

/// The displacements at which forces that depend on all of them have their values, by Broyden's method: what it learns
/// of the stiffness is returned for the next search. After a step that does not halve what is left the stiffness is
/// measured anew, and a step that brings too little then is damped (Levenberg 1944; Marquardt 1963). (Broyden 1965;
/// Dennis and Schnabel, Numerical Methods for Unconstrained Optimization, chapter 8.)
///
/// Forces are asked for no more closely than the next step can make use of: a share of what was left of them before.
/// Throws NoBalance where no force comes within `enough` of its value.
BalanceOfForces displacements_for_forces(const ForcesAt& forces, const Eigen::VectorXd& values, BalanceOfForces guess,
                                         double probe, double enough);

}  // namespace fretval::fem
