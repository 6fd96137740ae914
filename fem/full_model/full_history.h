#pragma once

#include <Eigen/Dense>

#include "fem/full_model/bordered_solver.h"
#include "fem/motion/motion.h"
#include "fem/motion/relaxation.h"
#include "fem/operators/harmonic_space.h"
#include "fem/ring_contact/punch_series.h"

namespace fretval::fem {

/// Ring pressures of the full model: a column for time 0, then one for the balance time of each step, as in
/// NormalHistory.
struct FullNormalHistory {
  Eigen::MatrixXd pressure;  ///< n_rings x (1 + n_cycles * steps_per_cycle)
  SolveCount count;
};

/// Ring tractions of the full model, at the instants of FullNormalHistory.
struct FullFrictionHistory {
  Eigen::MatrixXd traction;  ///< n_rings x (1 + n_cycles * steps_per_cycle)
  SolveCount count;
};

/// The verifier of normal_history: the same body and steps without condensation. Every degree of freedom is an unknown
/// of every iteration of every step, and the viscoelastic history lives at the quadrature points.
///
/// A body whose moduli all relax like G(t) has no history but that of its contact line, so that the two histories agree
/// to roundoff: they share the discretisation in space and time, and nothing of the solution.
///
/// space: that of the normal harmonic; series: by which find_courses() tells how far rings follow the indenter in a
/// step and where they turn; profile: ring means. The history starts from relaxed contact at the mean indentation.
/// Throws SolverError when a sparse solve fails, when an active set does not settle or when the contact reaches the
/// last ring, and std::invalid_argument for a wrong harmonic or profile size.
FullNormalHistory full_normal_history(const HarmonicSpace& space, const PunchSeries& series,
                                      const RelaxationModel& relaxation, const Eigen::VectorXd& profile,
                                      const Motion& motion, int steps_per_cycle, int n_cycles,
                                      SparseFactors factors = SparseFactors::kept);

/// The verifier of friction_history, from rest; see full_normal_history. space: that of the tangential harmonic;
/// pressure: of the rings, a column for each instant, the first of them unused.
FullFrictionHistory full_friction_history(const HarmonicSpace& space, const RelaxationModel& relaxation,
                                          double friction_coefficient, const Motion& motion,
                                          const Eigen::MatrixXd& pressure, int steps_per_cycle, int n_cycles,
                                          SparseFactors factors = SparseFactors::kept);

}  // namespace fretval::fem
