#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <vector>

#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// Mean over each ring of a profile f(r), which is smooth between its kinks: rising radii at which it bends or jumps.
/// Where f is a polynomial of degree up to 8 between its kinks, the volume over the rings, `sum_j A_j mean_j`, is exact
/// to roundoff.
Eigen::VectorXd ring_means(const Compliance& compliance, const std::function<double(double)>& f,
                           const std::vector<double>& kinks = {});

/// Ring pressures of a contact and the remaining gaps.
struct StaticContact {
  Eigen::VectorXd pressure, gap;
};

/// Memory in which contacts are solved, one after the other.
struct ContactRoom {
  BoxSolver::Target target;
  BoxSolver::Solution solution;
  Eigen::VectorXd lower, upper;
};

/// Elastic normal contact with unit shear modulus. target: displacements of the rings that would close their gaps;
/// states: warm start on entry, the states of the solution on exit (interior: touches).
StaticContact solve_contact(const ContactProblem& problem, const Eigen::VectorXd& target,
                            std::vector<BoxState>& states);

/// What rings lose in height under a pressure: `coefficient p^exponent`. Empty: nothing.
struct PressureWear {
  Eigen::VectorXd coefficient;  ///< per ring, not negative
  double exponent = 1;          ///< positive
};

/// Depth that is worn off each ring under a pressure; the wear must not be empty.
Eigen::VectorXd worn_by(const PressureWear& wear, const Eigen::VectorXd& pressure);

/// solve_contact while the rings of the indenter wear off under the pressure that is found, which lets them sink in
/// less: `target_i = (C p)_i/A_i + coefficient_i p_i^exponent - gap_i`. With the exponent 1 the wear is a diagonal
/// added to the compliance, the same for all targets; otherwise Newton's method iterates over such problems.
class WearingSolver {
 public:
  /// likely: states of the rings, interior where they probably touch. The problem must outlive this.
  WearingSolver(const ContactProblem& problem, PressureWear wear, const std::vector<BoxState>& likely);

  /// Throws SolverError where the iterations do not converge.
  void solve(const Eigen::VectorXd& target, std::vector<BoxState>& states, ContactRoom& room,
             StaticContact& contact) const;

 private:
  [[nodiscard]] StaticContact by_newton(const Eigen::VectorXd& target, std::vector<BoxState>& states) const;

  const ContactProblem& problem_;
  PressureWear wear_;
  std::optional<BoxSolver> softened_;  // for the exponent 1
};

/// Elastic normal contact at a given indentation, without wear. profile: ring means.
StaticContact static_contact(const ContactProblem& problem, const Eigen::VectorXd& profile, double indentation);

}  // namespace fretval::fem
