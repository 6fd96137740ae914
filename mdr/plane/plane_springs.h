#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "mdr/plane/plane_stick.h"
#include "mdr/profiles/profile.h"
#include "mdr/rheology/prony_body.h"
#include "mdr/springs/path_data.h"

namespace fretval::mdr {

/// Position of the indenter in m: its indentation, and its displacement along the surface. Where forces are prescribed
/// along the surface, x and y are F_x and F_y in N.
struct PlanePosition {
  double depth, x, y;
};

/// A motion in steps: from rest on it is at the first position, and then at the others at their instants, between which
/// it moves at a constant rate. A motion that repeats is at its first position again at its end.
struct PlaneMotion {
  PlanePosition rest;
  std::vector<double> time;  ///< s, from 0 on
  std::vector<PlanePosition> positions;
  bool repeats = false;
  bool by_force = false;  ///< along the surface

  [[nodiscard]] std::size_t n_steps() const { return time.size() - 1; }
};

/// Results of the spring foundation under a motion in two directions, over the cycle that repeats or over the pass.
struct PlaneResponse {
  double force_x_max, force_y_max;  ///< N, of |F_x|, |F_y|
  double force_x_mean;              ///< N
  double friction_work;             ///< J
  double tangential_work;           ///< J, of the indenter along the surface
  double normal_work;               ///< J, of the indenter into the body
  double way;                       ///< m, length of the path of the indenter along the surface
  double x_amplitude;               ///< m, half of what lies between the extremes of u_x
  StickDepths depths;               ///< of plane_stick_depths at the ends of the steps; first slip: since rest
};

/// The spring foundation with friction as a vector: per length of a spring
///
///   q_z = 4 int G(t-t') u_z' dt' >= 0,    q = (8/3) int G(t-t') u' dt',    |q| <= mu q_z,  slip along q where equal,
///
/// u = (u_x, u_y) of its tip: paper equations (1), (5), (6), (8) with a vector in the place of the tangential force. In
/// the normal direction springs are stepped as by SpringStep. In a step a spring that sticks moves with the indenter;
/// else its force is the one on the limit that points to where sticking would bring it (implicit, of first order in the
/// step where the direction of slip turns). A motion that repeats goes through cycles, amplitudes rising in the first
/// one, until the force, or the displacement where forces are prescribed, repeats to `periodicity` of its largest or
/// 100 cycles have passed. Under forces the indenter goes in each step where its springs bear them (way_for_forces). mu
/// positive. Throws std::invalid_argument, and GrossSlip for a force that friction does not bear.
PlaneResponse plane_response(const Profile& profile, const PronyBody& body, double mu, const PlaneMotion& motion,
                             Eigen::Index n_springs, double periodicity = 1e-7);

/// Forces, energies and depths of a response to a motion that prescribes depths. For a pass the works of the tangential
/// force and of the body are left out, as stored energy cannot be told from losses.
PathForces forces_of(const PlaneResponse& response, const PronyBody& body, const PlaneMotion& motion);

}  // namespace fretval::mdr
