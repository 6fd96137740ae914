#include "mdr/layer/layer_kernel.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mdr/layer/layer_response.h"
#include "mdr/support/checks.h"
#include "mdr/support/constants.h"
#include "mdr/support/gauss_legendre.h"

namespace fretval::mdr {

namespace {

// A panel of 30 points integrates what turns by 48 rad in it to (e 24/(4 30))^60 = 1e-16; in one of 22/6 the nearest
// pole of L, pi/2 beside the axis, allows for 1e-25.
QuadratureRule wave_rule(double reach_in_thicknesses) {
  constexpr double largest = 22, turn_of_panel = 48;
  constexpr int n_points = 30, least_panels = 6;
  const int n = std::max(least_panels, static_cast<int>(std::ceil(largest * reach_in_thicknesses / turn_of_panel)));
  std::vector<double> breaks;
  for (int i = 0; i <= n; ++i) breaks.push_back(largest * i / n);
  return gauss_legendre(breaks, n_points);
}

Eigen::MatrixXd cosines(const LayerKernel& kernel, const Eigen::ArrayXd& x) {
  return (kernel.wave_number.matrix() * x.matrix().transpose()).array().cos().matrix();
}

}  // namespace

LayerKernel layer_kernel(const Layer& layer, Direction direction, double reach) {
  validate(layer);
  require_positive("reach of the kernel", reach);
  require_within("reach of the kernel over the thickness of the layer", reach / layer.thickness, 0, 200);
  const QuadratureRule rule = wave_rule(reach / layer.thickness);
  LayerKernel kernel{layer, direction, reach, rule.point / layer.thickness, rule.weight / layer.thickness};
  for (Eigen::Index m = 0; m < rule.point.size(); ++m)
    kernel.weight[m] *= response_ratio_less_one(layer, direction, rule.point[m]);
  return kernel;
}

double kernel_value(const LayerKernel& kernel, double x) {
  require_within("distance", std::abs(x), 0, kernel.reach);
  return (kernel.weight * (kernel.wave_number * x).cos()).sum();
}

Eigen::ArrayXd amplitudes(const LayerKernel& kernel, const Eigen::ArrayXd& places, const Eigen::ArrayXd& shares) {
  return (cosines(kernel, places) * shares.matrix()).array();
}

double coupling(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, double x) {
  return 2 / pi * (kernel.weight * amplitudes * (kernel.wave_number * x).cos()).sum();
}

Eigen::ArrayXd coupling(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, const Eigen::ArrayXd& x) {
  return 2 / pi * (cosines(kernel, x).transpose() * (kernel.weight * amplitudes).matrix()).array();
}

double coupling_slope(const LayerKernel& kernel, const Eigen::ArrayXd& amplitudes, double x) {
  return -2 / pi * (kernel.weight * kernel.wave_number * amplitudes * (kernel.wave_number * x).sin()).sum();
}

Eigen::MatrixXd coupling_matrix(const LayerKernel& kernel, const Eigen::ArrayXd& points,
                                const Eigen::ArrayXd& weights) {
  const Eigen::MatrixXd waves = cosines(kernel, points);
  return 2 / pi * (waves.transpose() * kernel.weight.matrix().asDiagonal() * waves) * weights.matrix().asDiagonal();
}

}  // namespace fretval::mdr
