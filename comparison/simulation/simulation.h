#pragma once

#include <optional>

#include "comparison/simulation/fem_case.h"
#include "fem/history/friction_history.h"
#include "fem/history/normal_history.h"
#include "fem/stick_zone/edge_radius.h"
#include "fem/stick_zone/stick_depths.h"
#include "fem/stick_zone/stick_zones.h"

namespace fretval {

/// The normal contact of a scene, shared by all cases that differ in the tangential motion alone. Dimensionless.
struct NormalSimulation {
  fem::NormalHistory history;
  std::optional<fem::EdgeRadius> contact_radius;  ///< empty for a worn profile, whose flank touches without pressure
  Eigen::VectorXd profile;                        ///< ring means
  double contact_radius_uncertainty;              ///< of the time steps, see simulate_normal
  double seconds;
};

/// The largest contact radius is read at the ends of the steps; a second reading, at the balance times, differs from it
/// to second order. Where a branch relaxes within a step, coarser steps do not show the error, and twice that
/// difference is the uncertainty.
NormalSimulation simulate_normal(const fem::ContactProblem& problem, const FemCase& scene);

/// What the finite elements say about the state in which nothing wears any more. Dimensionless ratios.
struct NoWearEvidence {
  double slip_inside;        ///< longest slip of a ring inside c in a period over the tangential amplitude
  double force_outside;      ///< largest share of the normal force carried beyond c at any instant of the last cycle
  double touch_indentation;  ///< indentation at which the worn flank comes into contact, over the largest one
};

/// How many rings resolve the zones: in the largest contact, and inside either stick radius.
struct ZoneRings {
  Eigen::Index contact = 0;
  fem::StuckRings stuck = {};
};

/// What finite elements say about a scene; SI units. Empty: nothing sticks.
struct FeAnswer {
  std::optional<double> contact_radius_max;  ///< empty for a worn profile, see NormalSimulation
  std::optional<double> stick_radius_first_slip;
  std::optional<double> stick_radius_shakedown;
  double normal_force_max = 0;
  double contact_radius_uncertainty = 0;  ///< see simulate_normal
  double normal_force_uncertainty = 0;    ///< of reading the edge, see fem::ContactForce
  double first_slip_uncertainty = 0;      ///< of reading the edge, see fem::EdgeRadius
  double shakedown_uncertainty = 0;
  fem::StickDepths first_slip_depths, shakedown_depths;  ///< empty for a limiting profile
  std::optional<NoWearEvidence> no_wear;                 ///< for a limiting profile

  ZoneRings rings;
  int n_cycles = 0;
  long n_steps = 0;
  double seconds = 0;             ///< of the friction history
  fem::FrictionHistory friction;  ///< dimensionless
};

/// The contact problems of one body.
struct ContactProblems {
  const fem::ContactProblem& normal;
  const fem::ContactProblem* tangential;  ///< null: the indenter does not move tangentially
};

/// Without tangential motion no friction is solved for: what never loses contact sticks.
FeAnswer simulate(const ContactProblems& problems, const FemCase& scene, const NormalSimulation& normal);

}  // namespace fretval
