#pragma once

#include <Eigen/Dense>

namespace fretval::fem {

/// What a stick zone is read from, ring by ring from the centre; only rings in the largest contact.
struct StickRings {
  Eigen::VectorXd reserve;  ///< see FrictionHistory
  Eigen::VectorXd slip;     ///< by how far it exceeds what sticks, as displacements of PunchSeries
  Eigen::Index n_stuck;
};

/// How deep rings are inside a stick zone, and the radii that this belongs to. Both dimensionless.
struct StickDepths {
  Eigen::VectorXd depth, radius;
};

/// In the elastic contact d_stick - g(r) (Cattaneo and Mindlin), from the reserves of the rings over
/// tangential_per_depth = 3 mu/2. A ring that slips has no reserve left to tell; minus its slip stands for it: its path
/// from the start on, or, to and fro, a quarter of that in a period. In a body that is stiff in motion that is less, by
/// |G|/G'(0) at most. Slips count up to 2 u_x0, so that it does not matter for how long a ring has slipped.
/// radii: PunchSeries::radii; amplitude: u_x0.
StickDepths stick_depths(const StickRings& rings, const Eigen::VectorXd& radii, double tangential_per_depth,
                         double amplitude);

/// How far the edge of the stick zone may lie from c if all depths are off by `uncertainty`: the larger distance from c
/// to where they fall to it and to minus it. Under a flat face g hardly changes, and a small depth decides whether all
/// of the face sticks or nothing. Where the depths end, the edge may be that of the contact, 1.
double reach_of_edge(const StickDepths& depths, double c, double uncertainty);

/// How far apart the depths fall to `uncertainty` and to minus it: twice what the edge moves if all of them are off by
/// that. Unlike reach_of_edge it does not count that the edge is read more finely than the depths are spaced: they fall
/// as between the last two rings that stick, for a slip that has added up for long falls more steeply.
double width_of_edge(const StickDepths& depths, double uncertainty);

}  // namespace fretval::fem
