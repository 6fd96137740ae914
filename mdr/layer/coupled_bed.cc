#include "mdr/layer/coupled_bed.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mdr/support/constants.h"

namespace fretval::mdr {

namespace {

constexpr Eigen::Index springs_of_block = 16;

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

LayerModes::LayerModes(Eigen::MatrixXd shape_of_springs, Eigen::ArrayXd strength_of_modes)
    : shape(std::move(shape_of_springs)),
      strength(std::move(strength_of_modes)),
      pulled(shape * strength.matrix().asDiagonal()) {
  for (Eigen::Index first = 0; first < shape.rows(); first += springs_of_block) {
    const Eigen::Index n = std::min(springs_of_block, shape.rows() - first);
    response_of_block_.emplace_back(shape.middleRows(first, n).transpose() * pulled.middleRows(first, n));
  }
}

Eigen::MatrixXd LayerModes::response(const Eigen::ArrayXd& give) const {
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(strength.size(), strength.size());
  Eigen::Index first = 0;
  for (const auto& of_block : response_of_block_) {
    const auto own = give.segment(first, std::min(springs_of_block, give.size() - first));
    if ((own != own[0]).any())
      sum.noalias() += shape.middleRows(first, own.size()).transpose() *
                       (own.matrix().asDiagonal() * pulled.middleRows(first, own.size()));
    else if (own[0] != 0)
      sum += own[0] * of_block;
    first += own.size();
  }
  return sum;
}

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
  Eigen::MatrixXd shape(bed.position.size(), kept.size());
  Eigen::ArrayXd strength(kept.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    shape.col(static_cast<Eigen::Index>(k)) = basis * all.eigenvectors().col(kept[k]);
    strength[static_cast<Eigen::Index>(k)] = all.eigenvalues()[kept[k]];
  }
  return {std::move(shape), std::move(strength)};
}

Eigen::ArrayXd coupling(const LayerModes& modes, const Eigen::ArrayXd& load) {
  return (modes.pulled * (modes.shape.transpose() * load.matrix())).array();
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
