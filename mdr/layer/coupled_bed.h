#pragma once

#include <Eigen/Core>
#include <vector>

#include "mdr/layer/layer_kernel.h"
#include "mdr/springs/spring_bed.h"

namespace fretval::mdr {

/// What a layer adds to the loads of the springs of a bed, (1/pi) int K(x-y) q(y) dy, as a matrix in few modes:
///
///   coupling of spring i = sum_m shape_im strength_m sum_j shape_jm q_j
///
/// The kernel is smooth, so that some 20 modes hold it to roundoff, however many springs there are: a step is solved in
/// those. They come from Galerkin's rule, with loads uniform over each spring and the mean of the coupling over it. Its
/// matrix is symmetric, so that what springs do to each other conserves energy; its error is of second order in the
/// width of the springs, like their own.
struct LayerModes {
  LayerModes(Eigen::MatrixXd shape, Eigen::ArrayXd strength);

  Eigen::MatrixXd shape;       ///< springs x modes, orthonormal
  Eigen::ArrayXd strength;     ///< above -1, so that depths determine the loads
  Eigen::MatrixXd pulled;      ///< springs x modes, shape times strength: the coupling by each mode
  Eigen::MatrixXd at_springs;  ///< modes x springs, the transposed shape: what belongs to a spring lies together

  /// Share of the loads of the springs in each mode, sum_j shape_jm q_j.
  [[nodiscard]] Eigen::VectorXd shares_of(const Eigen::ArrayXd& load) const;

  /// Coupling of each spring under such shares.
  [[nodiscard]] Eigen::ArrayXd coupling_of(const Eigen::VectorXd& share) const;

  /// What springs that give by g_j do to the modes, sum_j shape_jm g_j pulled_jn. Neighbours mostly give by the same;
  /// their part is known, so that it takes modes^2 for each 16 of them.
  [[nodiscard]] Eigen::MatrixXd response(const Eigen::ArrayXd& give) const;

 private:
  std::vector<Eigen::MatrixXd> response_of_block_;  // to a give of 1 of 16 neighbours
};

/// The modes of a bed of springs of equal width. Throws std::invalid_argument for springs of unequal widths.
LayerModes layer_modes(const LayerKernel& kernel, const SpringBed& bed);

/// The coupling of each spring under these loads of the springs, in the unit of `load`.
Eigen::ArrayXd coupling(const LayerModes& modes, const Eigen::ArrayXd& load);

/// Springs and the modes that couple them in either direction; without modes they are the independent springs of a
/// half-space. A layer on a frictionless base has no tangential modes, and must not be moved tangentially.
struct CoupledBed {
  SpringBed springs;
  Layer layer;
  LayerModes normal, tangential;
};

CoupledBed coupled_bed(const SpringBed& springs, const Layer& layer);

}  // namespace fretval::mdr
