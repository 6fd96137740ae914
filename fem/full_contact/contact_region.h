#pragma once

#include <Eigen/Dense>
#include <vector>

#include "fem/full_contact/angular_grid.h"
#include "fem/ring_contact/contact_problem.h"

namespace fretval::fem {

/// A region around the centre of the contact.
struct ContactRegion {
  double area = 0;
  double radius = 0;            ///< of the disc of that area
  double along = 0;             ///< half of its extent along x
  double across = 0;            ///< half of its extent along y
  double uncertainty = 0;       ///< of the radius, as if the edge were off by its uncertainty at all angles to one side
  double edge_uncertainty = 0;  ///< of the edge, the largest over the angles
  Eigen::VectorXd edges{};      ///< radius of its edge at each kept angle
};

/// The region in which a margin is positive from the centre on, whose edge is read to a fraction of a ring.
///
/// A margin, mu p - |t| where points stick or p where they touch, falls towards the edge like the pressure of a punch.
/// Therefore on each ray the margin is read as that of an axisymmetric contact, whose depths (PunchSeries) vanish at
/// the edge (stick_radius): near a smooth edge the problem is that of a straight one. depths: the depths of the margin,
/// in which they are linear, n_rings x n_angles; n_inside: the number of rings inside the region on each ray. area =
/// (1/2) int edge(theta)^2 dtheta, by the trapezoidal rule, which converges faster than any power of the number of
/// angles for a smooth region; extents are those of the trigonometric polynomial through the edges. rings: the contact
/// problem of the ring contact on the same rings, in the component (normal or tangential) to which the margin belongs.
ContactRegion region_of(const ContactProblem& rings, const AngularGrid& grid, const Eigen::MatrixXd& depths,
                        const Eigen::VectorXi& n_inside);

/// The region whose edge at each kept angle is known.
ContactRegion region_within(const AngularGrid& grid, Eigen::VectorXd edges);

/// The region in which a margin is positive from the centre on, from the margin itself (n_rings x n_angles), which is
/// zero outside of the region.
ContactRegion region_of(const ContactProblem& rings, const AngularGrid& grid, const Eigen::MatrixXd& margin);

/// The region whose edge on each ray is the outer one of its last ring, known to within a ring. Nothing is assumed of
/// how the margin falls towards the edge: it does so like the pressure of a punch where a stick zone shrinks, and in
/// proportion to the distance where it grows. radii: edges of the rings, one more than rings.
ContactRegion region_to_a_ring(const std::vector<double>& radii, const AngularGrid& grid,
                               const Eigen::VectorXi& n_inside);

/// Number of rings on each ray before the first one whose margin is not positive.
Eigen::VectorXi rings_inside(const Eigen::MatrixXd& margin);

}  // namespace fretval::fem
