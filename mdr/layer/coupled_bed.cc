#include "mdr/layer/coupled_bed.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "mdr/support/constants.h"

namespace fretval::mdr {

LayerModes layer_modes(const LayerKernel& kernel, const SpringBed& bed) {
  const double width = bed.width[0];
  if ((bed.width - width).abs().maxCoeff() > 1e-9 * width)
    throw std::invalid_argument("widths of the springs of a layer: must be equal");
  const Eigen::ArrayXd half_turn = kernel.wave_number * width / 2, mean = half_turn.sin() / half_turn;
  const Eigen::MatrixXd waves =
      (kernel.wave_number.matrix() * bed.position.matrix().transpose()).array().cos().matrix();
  const Eigen::ArrayXd weight = 2 / pi * width * kernel.weight * mean.square();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(waves.transpose() * weight.matrix().asDiagonal() * waves);
  constexpr double roundoff = 1e-15;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index m = 0; m < all.eigenvalues().size(); ++m)
    if (std::abs(all.eigenvalues()[m]) > roundoff) kept.push_back(m);
  LayerModes modes{Eigen::MatrixXd(bed.position.size(), kept.size()), Eigen::ArrayXd(kept.size())};
  for (std::size_t k = 0; k < kept.size(); ++k) {
    modes.shape.col(static_cast<Eigen::Index>(k)) = all.eigenvectors().col(kept[k]);
    modes.strength[static_cast<Eigen::Index>(k)] = all.eigenvalues()[kept[k]];
  }
  return modes;
}

Eigen::ArrayXd coupling(const LayerModes& modes, const Eigen::ArrayXd& load) {
  return (modes.shape * (modes.strength.matrix().asDiagonal() * (modes.shape.transpose() * load.matrix()))).array();
}

CoupledBed coupled_bed(const SpringBed& springs, const Layer& layer) {
  const Eigen::Index last = springs.position.size() - 1;
  const double reach = 2 * (springs.position[last] + springs.width[last]);
  const auto modes = [&](Direction direction) { return layer_modes(layer_kernel(layer, direction, reach), springs); };
  const LayerModes none{Eigen::MatrixXd(springs.position.size(), 0), Eigen::ArrayXd(0)};
  validate(layer);
  if (std::isinf(layer.thickness)) return {springs, layer, none, none};
  return {springs, layer, modes(Direction::normal),
          layer.base == LayerBase::bonded ? modes(Direction::tangential) : none};
}

}  // namespace fretval::mdr
