#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "mdr/layer/layer.h"

namespace fretval::mdr {

/// Surface displacements of a layer with G = 1 under unit waves cos(kx) of traction, from the matrix exponential of
/// Navier's equations over its thickness, which knows nothing of the closed forms. With u_x = U(z) sin kx, u_z = W(z)
/// cos kx and the stresses S = sigma_zz, T = tau_xz of the same waves:
///
///   U' = T + kW,   W' = ((1-2 nu)/2 S - nu k U)/(1-nu),   S' = -kT,   T' = k (nu S + 2 k U)/(1-nu)
struct LayerWaves {
  double normal, along, across;  ///< m_N, m_L, m_T
};

inline LayerWaves layer_waves(const Layer& layer, double k) {
  const double nu = layer.poisson_ratio, H = layer.thickness;
  Eigen::Matrix4d rates;
  rates << 0, k, 0, 1,                                          //
      -nu * k / (1 - nu), 0, (1 - 2 * nu) / (2 * (1 - nu)), 0,  //
      0, 0, 0, -k,                                              //
      2 * k * k / (1 - nu), 0, nu * k / (1 - nu), 0;
  const Eigen::Matrix4d through = (H * rates).exp();
  // At the base W = 0 and, bonded, U = 0 or else T = 0: two rows for the displacements of the surface.
  const int held[] = {1, layer.base == LayerBase::bonded ? 0 : 3};
  Eigen::Matrix2d of_displacements, of_stresses;
  for (int i = 0; i < 2; ++i) {
    of_displacements.row(i) = through.block<1, 2>(held[i], 0);
    of_stresses.row(i) = through.block<1, 2>(held[i], 2);
  }
  const auto surface = [&](double normal_stress, double shear_stress) -> Eigen::Vector2d {
    return -of_displacements.inverse() * (of_stresses * Eigen::Vector2d(normal_stress, shear_stress));
  };
  return {surface(-1, 0)[1], surface(0, -1)[0], std::tanh(k * H) / k};
}

}  // namespace fretval::mdr
