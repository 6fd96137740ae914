#pragma once

#include <Eigen/Core>

#include "mdr/layer/layer.h"

namespace fretval::mdr {

/// What couples the springs of a layer. A row of MDR bears the loads per length q under the depths w:
///
///   E* w(x) = q(x) + (1/pi) int_-a^a K(x-y) q(y) dy,     K(x) = int_0^inf (L(kH) - 1) cos(kx) dk
///
/// with G* for E* and the other L (mdr/layer/layer_response.h) tangentially. K is smooth, and vanishes with a/H, which
/// leaves the independent springs of a half-space.
/// Derivation: with q(x) = 2 int_x^a p r/sqrt(r^2-x^2) dr the Hankel transform of the pressure is the cosine transform
/// of q, over pi; a layer multiplies every wave by L; and the transform of the displacement takes J0(kr) to cos(kx).
///
/// The integral over wave numbers is a sum at fixed k_m, the points of Gauss and Legendre on panels up to k H = 22,
/// where L - 1 is 1e-16:
///
///   K(x) = sum_m weight_m cos(k_m x)
///
/// to roundoff for |x| <= reach, whatever is small or large. A sum of cosines is also what makes it cheap: cos k(x-y)
/// + cos k(x+y) = 2 cos kx cos ky, so that a row of springs needs its matrix in factors, and a load acts everywhere
/// through its few hundred amplitudes.
struct LayerKernel {
  Layer layer;
  Direction direction;
  double reach;                ///< m
  Eigen::ArrayXd wave_number;  ///< k_m in 1/m
  Eigen::ArrayXd weight;       ///< 1/m
};

/// reach in m, positive: the largest |x-y| that occurs, for a contact of radius a 2 a; up to 200 H. Throws
/// std::invalid_argument for bad arguments and for a tangential kernel on a frictionless base.
LayerKernel layer_kernel(const Layer& layer, Direction direction, double reach);

/// K(x) in 1/m, |x| <= reach.
double kernel_value(const LayerKernel& kernel, double x);

/// Amplitudes sum_j cos(k_m x_j) share_j of the loads share_j = q_j dx_j at places x_j > 0, which the other side of the
/// axis mirrors.
Eigen::ArrayXd amplitudes(const LayerKernel& kernel, const Eigen::ArrayXd& places, const Eigen::ArrayXd& shares);

/// (1/pi) int_-a^a K(x-y) q(y) dy of a load with these amplitudes, at x in m inside the contact or beyond it: by how
/// much q(x) falls short of that of independent springs. In the unit of q.
double coupling(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, double x);
Eigen::ArrayXd coupling(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, const Eigen::ArrayXd& x);

/// Slope of this coupling in x, in the unit of q per m.
double coupling_slope(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, double x);

/// Matrix of the coupling of loads at the points of a rule on x > 0: coupling(x_i) = sum_j matrix(i,j) q_j.
Eigen::MatrixXd coupling_matrix(const LayerKernel& kernel, const Eigen::ArrayXd& points, const Eigen::ArrayXd& weights);

}  // namespace fretval::mdr
