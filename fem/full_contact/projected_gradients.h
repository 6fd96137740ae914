#pragma once

#include <Eigen/Dense>

#include "fem/full_contact/coupled_contact.h"
#include "fem/full_contact/surface_operator.h"
#include "fem/full_contact/vector_friction.h"

namespace fretval::fem {

/// The largest eigenvalue of an operator, or a little more, by power iteration: its inverse is the length of a gradient
/// step.
double largest_eigenvalue(const SurfaceOperator& op);

// The friction and the normal problem of the full contact by an algorithm that shares nothing with their solvers but
// the operator: accelerated projected gradients (Nesterov 1983) with restarts (O'Donoghue and Candes 2015). They take
// hundreds to thousands of applications where Newton's method takes tens. They start from zero and end when an iterate
// moves by less than 1e-12 of the largest traction or pressure, or after 20000 iterations.

/// Tractions of the problem of FrictionSolver.
Eigen::MatrixXd friction_by_projected_gradients(const SurfaceOperator& op, double eigenvalue,
                                                const Eigen::MatrixXd& pull, const Eigen::MatrixXd& limit);

/// Pressures of the problem of solve_pressure().
Eigen::MatrixXd pressure_by_projected_gradients(const SurfaceOperator& op, double eigenvalue,
                                                const Eigen::MatrixXd& target);

/// Solves the steps of a contact once more, and keeps by how much the two algorithms differ. In a coupled contact
/// friction is solved under the pressures of the step, and pressures under its tractions: both can agree only at a
/// fixed point of the alternation.
class SecondAlgorithm {
 public:
  /// To be called after each step of the contact.
  void see(const VectorFriction& friction);
  void see(const CoupledContact& contact);
  /// The largest difference of a traction over the largest friction limit of its step, or of a pressure over the
  /// largest one, of all steps.
  [[nodiscard]] double difference() const { return difference_; }

 private:
  double eigenvalue_ = 0, normal_eigenvalue_ = 0, difference_ = 0;
};

}  // namespace fretval::fem
