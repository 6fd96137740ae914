#pragma once

#include <Eigen/Core>

#include "mdr/rheology/prony_body.h"

namespace fretval::mdr {

/// One viscoelastic spring of the foundation with forces divided by 4 G0 per length and time by 1/omega, so that a
/// cycle lasts 2 pi. With u the depth of its tip and v_i the part of it taken up by the dashpot of branch i,
///
///   f = u + sum_i gamma_i (u - v_i) + e u',    v_i' = (u - v_i)/T_i,
///   gamma_i = G_i/G0,  T_i = omega tau_i,  e = omega eta/G0
///
/// Unlike branch forces, the v_i run on smoothly, without a kink in time, when contact is lost or regained.
/// Source: the Prony form of paper equation (5).

/// The unloaded spring, f = 0, is a gradient flow C s' = -B^T B s of its stored energy against its dissipation, with
/// the state s = (u, v_1, ...) when e > 0, s = (v_1, ...) otherwise. It decays in modes:
///   s(t) = from_modes exp(-rates t) to_modes s(0),    u(t) = depth_of_modes exp(-rates t) to_modes s(0)
struct FreeRecovery {
  Eigen::ArrayXd rates;  ///< per radian, positive
  Eigen::MatrixXd to_modes;
  Eigen::MatrixXd from_modes;
  Eigen::RowVectorXd depth_of_modes;
};

struct SpringModel {
  Eigen::ArrayXd branch_moduli;  ///< gamma_i
  Eigen::ArrayXd branch_times;   ///< T_i
  double viscosity;              ///< e
  double storage;                ///< G'(omega)/G0
  double loss;                   ///< G''(omega)/G0
  FreeRecovery recovery;
};

/// The spring of a body that is driven at the angular frequency omega > 0 in rad/s. Throws std::invalid_argument.
SpringModel spring_model(const PronyBody& body, double omega);

/// Number of leading entries of the free state s that hold u: 1 with a dashpot, else 0.
Eigen::Index n_depth_states(const SpringModel& model);

/// v_i at the angle theta = omega t of a spring that follows u = y + cos(theta) for ever:
///   y + (cos(theta) + T_i sin(theta))/(1 + T_i^2)
Eigen::ArrayXd harmonic_branch_depths(const SpringModel& model, double y, double theta);

/// The force of such a spring: y + G' cos(theta) - G'' sin(theta), moduli divided by G0.
double harmonic_force(const SpringModel& model, double y, double theta);

}  // namespace fretval::mdr
