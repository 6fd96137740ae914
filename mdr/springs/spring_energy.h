#pragma once

#include "mdr/rheology/prony_body.h"
#include "mdr/springs/spring_bed.h"
#include "mdr/springs/spring_step.h"

namespace fretval::mdr {

/// Forces on the indenter.
struct SpringForces {
  double normal, tangential;  ///< N
  double axis_pressure;       ///< Pa
};

/// Forces on the indenter and energies of the whole foundation, both sides of the axis: 2 sum(width ...). SI units.

/// Forces in N per sum(width * load): 8 G0 and (16/3) G0.
double normal_scale(const PronyBody& body);
double tangential_scale(const PronyBody& body);

/// Normal and tangential force on the indenter in N, by the loads of whole springs.
double normal_force(const SpringBed& bed, const PronyBody& body, const SpringState& state);
double tangential_force(const SpringBed& bed, const PronyBody& body, const SpringState& state);

/// What the widths of springs lack, or have too much: whole springs are in contact or not. With these widths added to
/// theirs, in m, what is in contact ends at the edge of the contact, which is where the free tips next to it,
/// extrapolated, meet the indenter; whatever is summed goes on linearly from the last two springs up to there. Without
/// them sums of what does not vanish at the edge are off by up to half a spring: heat in bodies with memory,
/// stiffnesses (and by these what small oscillations lose), and with a dashpot, whose load jumps where a spring
/// touches, everything. Springs of equal width; 0 for less than three springs.
Eigen::ArrayXd edge_widths(const SpringBed& bed, const SpringState& state);

/// Directions in which forces are prescribed. Whole springs balance these, and nothing is added at the edge.
struct ByForce {
  bool normal = false, tangential = false;
};

/// Forces on the indenter. weights: axis_weights of the bed.
SpringForces forces_of_springs(const SpringBed& bed, const PronyBody& body, const Eigen::ArrayXd& weights,
                               const SpringState& state, const ByForce& by_force);

/// Pressure on the axis in Pa. weights: axis_weights of the bed.
double axis_pressure(const Eigen::ArrayXd& weights, const PronyBody& body, const SpringState& state);

/// Energy in J stored in the springs: relaxed ones and those of the branches.
double stored_energy(const SpringBed& bed, const PronyBody& body, const SpringState& state);

/// Energy in J that one step turned into heat.
struct Dissipation {
  double friction = 0;  ///< traction times slip, with what a spring releases when it loses contact under traction
  double bulk = 0;      ///< dashpots of the branches and the parallel one
};

/// Widths by which heat is summed over the springs, m.
struct HeatWidths {
  Eigen::ArrayXd friction, bulk;
};

/// The widths of the springs with the mean of the edge_widths at the start and at the end of a step, unless whole
/// springs balance a normal force; for friction, which vanishes at the edge otherwise, with a dashpot alone.
HeatWidths widths_in_step(const SpringBed& bed, const PronyBody& body, const SpringState& before,
                          const SpringState& after, const ByForce& by_force);

/// Heat of the step of length dt in s from one state to the next. Branches: exact for linear motion of the tips.
/// Friction: slip under the friction limit, from where the growing traction of the stuck spring meets it to the end of
/// the step; exact for elastic springs, also for those that lose contact, whose release is what relaxation damping is
/// made of (Popov, Popov and Pohrt, Scientific Reports 5 (2015) 16189).
Dissipation dissipation(const HeatWidths& width, const PronyBody& body, double mu, double dt, const SpringState& before,
                        const SpringState& after);

/// Heat of the dashpots of one direction in a step, over the force scale of that direction (normal_scale or
/// tangential_scale above), m^2. memory: of the springs at the start of the step (springs x branches, m), move: of the
/// tips in the step, m. The widths may be weights of any quadratic form in these variables.
double bulk_heat(const Eigen::ArrayXd& width, const PronyBody& body, double dt, const Eigen::ArrayXXd& memory,
                 const Eigen::ArrayXd& move);
/// Heat of friction in a step, over tangential_scale, m^2. friction_limit: mu E*/G*, which is (3/2) mu for
/// dissipation().
double friction_heat(const Eigen::ArrayXd& width, const PronyBody& body, double friction_limit, double dt,
                     const SpringState& before, const SpringState& after);

}  // namespace fretval::mdr
