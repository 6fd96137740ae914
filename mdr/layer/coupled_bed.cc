#include "mdr/layer/coupled_bed.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

// Orthonormal columns over the springs that hold cos(kx) to roundoff for all waves of the kernel: even Chebyshev
// polynomials of x over the length, of which a wave has the amounts J_2p(k length), nothing beyond its turns. Where
// that takes half as many columns as there are springs or more, a column for each spring.
Eigen::MatrixXd basis_of_waves(const LayerKernel& kernel, const SpringBed& bed) {
  constexpr Eigen::Index beyond_turns = 20;
  const Eigen::Index n = bed.position.size();
  const double length = bed.position[n - 1] + bed.width[n - 1] / 2;
  const auto n_needed = static_cast<Eigen::Index>(kernel.wave_number.maxCoeff() * length / 2) + beyond_turns;
  if (2 * n_needed >= n) return Eigen::MatrixXd::Identity(n, n);
  Eigen::MatrixXd polynomials(n, n_needed);
  const Eigen::ArrayXd angle = (bed.position / length).acos();
  for (Eigen::Index p = 0; p < n_needed; ++p) polynomials.col(p) = (2 * static_cast<double>(p) * angle).cos();
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(polynomials);
  return factors.householderQ() * Eigen::MatrixXd::Identity(n, n_needed);
}

}  // namespace

LayerModes layer_modes(const LayerKernel& kernel, const SpringBed& bed) {
  const double width = bed.width[0];
  if ((bed.width - width).abs().maxCoeff() > 1e-9 * width)
    throw std::invalid_argument("widths of the springs of a layer: must be equal");
  const Eigen::ArrayXd half_turn = kernel.wave_number * width / 2, mean = half_turn.sin() / half_turn;
  const Eigen::MatrixXd basis = basis_of_waves(kernel, bed);
  const Eigen::MatrixXd waves =
      (kernel.wave_number.matrix() * bed.position.matrix().transpose()).array().cos().matrix() * basis;
  const Eigen::ArrayXd weight = 2 / pi * width * kernel.weight * mean.square();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(waves.transpose() * weight.matrix().asDiagonal() * waves);
  constexpr double roundoff = 1e-15;
  std::vector<Eigen::Index> kept;
  for (Eigen::Index m = 0; m < all.eigenvalues().size(); ++m)
    if (std::abs(all.eigenvalues()[m]) > roundoff) kept.push_back(m);
  LayerModes modes{Eigen::MatrixXd(bed.position.size(), kept.size()), Eigen::ArrayXd(kept.size())};
  for (std::size_t k = 0; k < kept.size(); ++k) {
    modes.shape.col(static_cast<Eigen::Index>(k)) = basis * all.eigenvectors().col(kept[k]);
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
