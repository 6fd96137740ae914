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

/// What normal_force() lacks, or has too much, in a body with a dashpot: loads jump where springs touch, so that the
/// force of whole springs is a sawtooth in time. It is the load from the end of the last spring in contact to the edge
/// of the contact, which is where the free tips next to it, extrapolated, meet the indenter; in N. With it the force is
/// of second order in the width of the springs. Springs of equal width; 0 without a dashpot, and of less than three
/// springs.
double edge_force(const SpringBed& bed, const PronyBody& body, const SpringState& state);

/// Pressure on the axis in Pa. weights: axis_weights of the bed.
double axis_pressure(const Eigen::ArrayXd& weights, const PronyBody& body, const SpringState& state);

/// Energy in J stored in the springs: relaxed ones and those of the branches.
double stored_energy(const SpringBed& bed, const PronyBody& body, const SpringState& state);

/// Energy in J that one step turned into heat.
struct Dissipation {
  double friction = 0;  ///< traction times slip, with what a spring releases when it loses contact under traction
  double bulk = 0;      ///< dashpots of the branches and the parallel one
};

/// Heat of the step of length dt in s from one state to the next. Branches: exact for linear motion of the tips.
/// Friction: slip under the friction limit, from where the growing traction of the stuck spring meets it to the end of
/// the step; exact for elastic springs, also for those that lose contact, whose release is what relaxation damping is
/// made of (Popov, Popov and Pohrt, Scientific Reports 5 (2015) 16189).
Dissipation dissipation(const SpringBed& bed, const PronyBody& body, double mu, double dt, const SpringState& before,
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
