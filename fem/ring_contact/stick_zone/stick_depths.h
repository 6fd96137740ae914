#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// Values from which a stick zone is read, per ring from the centre, for the rings of the largest contact.
struct StickRings {
  Eigen::VectorXd reserve;  ///< see FrictionHistory
  Eigen::VectorXd slip;     ///< beyond what a ring that sticks may slip, as displacements of PunchSeries
  Eigen::Index n_stuck;
};

/// Depths of the rings inside a stick zone, and the radii to which they belong. Dimensionless.
struct StickDepths {
  Eigen::VectorXd depth, radius;
};

/// In the elastic contact d_stick - g(r) (Cattaneo and Mindlin), from the reserves of the rings over
/// tangential_per_depth = 3 mu/2. A ring that slips has no reserve; minus its slip takes its place: the path of slip
/// from the start on, or, for slip to and fro, a quarter of the path in a period. In a body that is stiff in motion
/// slips are smaller than the depths they stand for, by |G|/G'(0) at most. Slips count up to `longest`; with 2 u_x0 it
/// does not matter for how long a ring has slipped. radii: PunchSeries::radii.
StickDepths stick_depths(const StickRings& rings, const Eigen::VectorXd& radii, double tangential_per_depth,
                         double longest);

/// Whether not even a spot inside the innermost ring sticks: whether its depth would still be below 0 if the depths
/// rose to the centre by twice what they fall by to the next ring. Under r^n they rise by 1/(3^n - 1) of that, 1.4
/// times for n = 1/2. For slips of any length, of rings that never lift.
bool sticks_nowhere(const StickDepths& depths);

/// How far the edge of the stick zone may lie from c if all depths are off by `uncertainty`: the larger distance from c
/// to the radii at which they fall to it and to minus it. Under a flat face g hardly changes, and a small depth decides
/// whether all of the face sticks or nothing. Where the depths end before, the edge may be that of the contact, 1.
double reach_of_edge(const StickDepths& depths, double c, double uncertainty);

/// Distance between the radii at which the depths fall to `uncertainty` and to minus it: twice the shift of the edge if
/// all depths are off by that. Unlike in reach_of_edge the depths are taken to fall as between the last two rings that
/// stick, as slip that has added up for long falls more steeply.
double width_of_edge(const StickDepths& depths, double uncertainty);

}  // namespace fretval::fem
