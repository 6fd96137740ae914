#pragma once

#include "mdr/layer/coupled_bed.h"
#include "mdr/springs/history_data.h"
#include "mdr/springs/spring_energy.h"

namespace fretval::mdr {

/// Force of a bed in N over sum(width * load) in m^2: 2 E* or 2 G* with the relaxed modulus, Pa.
double force_scale(const CoupledBed& bed, const PronyBody& body, Direction direction);

/// Forces on the indenter, and the pressure on the axis: forces_of_springs() of mdr/springs/spring_energy.h.
SpringForces coupled_forces(const CoupledBed& bed, const PronyBody& body, const Eigen::ArrayXd& weights,
                            const SpringState& state, const ByForce& by_force);

/// Energy in J that one step of coupled springs turns into heat. Their energy is a quadratic form of the depths, with
/// the inverse of the coupling in the place of the widths, so that the memory of every mode dissipates by itself.
Dissipation dissipation(const CoupledBed& bed, const PronyBody& body, double mu, double dt, const SpringState& before,
                        const SpringState& after);

/// zone_depth() of c in m from the three outermost of the springs that stick, counted from the axis: the parabola of
/// their zone depths over their least friction margins, read where the margin is 0. Over a half-space g is linear in
/// the margin. Springs stick as long as their margins are positive, whatever they still slip while they settle: slip to
/// one side takes from one margin what it gives to the other, and the shakedown depth is read from the mean of both.
/// margin: as for stick_depth() of mdr/springs/spring_stick.h. slip_of_innermost: how far the innermost spring slips
/// one way, m, which tells the depth where no spring sticks, as there.
double coupled_stick_depth(const SpringBed& bed, double friction_limit, const Eigen::ArrayXd& margin,
                           double slip_of_innermost);

/// spring_history() of mdr/springs/spring_history.h on a layer: the same loading, control and results, with
/// mdr/layer/coupled_step.h for its step. Depths of stick zones are those of the unworn image, so that the radii are
/// their zone_radius(); settling_depth is depths.shakedown, as both are read from margins alone. Loads in states are
/// over E* and G* with the relaxed modulus.
SpringHistory coupled_history(const CoupledBed& bed, const PronyBody& body, double mu, const Loading& loading,
                              const HistoryControl& control);

}  // namespace fretval::mdr
