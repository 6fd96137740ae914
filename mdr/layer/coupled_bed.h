#pragma once

#include <Eigen/Core>

#include "mdr/layer/layer_kernel.h"
#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// What a layer adds to the loads of the springs of a bed, (1/pi) int K(x-y) q(y) dy, as a matrix in few modes:
///
///   coupling of spring i = sum_m shape_im strength_m sum_j shape_jm q_j
///
/// The kernel is smooth, so that some 20 modes hold it to roundoff, however many springs there are: a step is solved in
/// those. By Galerkin's rule, loads uniform over each spring and the mean over it, which is symmetric: what springs do
/// to each other conserves energy. Of second order in the width, as the springs are.
struct LayerModes {
  Eigen::MatrixXd shape;    ///< springs x modes, orthonormal
  Eigen::ArrayXd strength;  ///< above -1, so that loads and depths give each other
};

/// Springs of equal width. Throws std::invalid_argument for others.
LayerModes layer_modes(const LayerKernel& kernel, const SpringBed& bed);

/// The coupling of loads.
Eigen::ArrayXd coupling(const LayerModes& modes, const Eigen::ArrayXd& load);

/// Springs and what couples them; no modes: the independent springs of a half-space. A frictionless base has no
/// tangential ones, and must not be moved tangentially.
struct CoupledBed {
  SpringBed springs;
  Layer layer;
  LayerModes normal, tangential;
};

CoupledBed coupled_bed(const SpringBed& springs, const Layer& layer);

}  // namespace fretval::mdr
