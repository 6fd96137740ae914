#include "mdr/layer/coupled_bed.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "mdr/support/constants.h"
#include "mdr/support/wide_registers.h"

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

// matrix * x, four columns at a time: columns of some 20 or some 100 numbers are too short for a library's own product.
Eigen::VectorXd sum_of_columns(const Eigen::MatrixXd& matrix, const double* x) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(matrix.rows());
  in_wide_registers([to = sum.data(), first = matrix.data(), n = matrix.rows(), n_columns = matrix.cols(), x] {
    Eigen::Index k = 0;
    for (; k + 4 <= n_columns; k += 4) {
      const double x0 = x[k], x1 = x[k + 1], x2 = x[k + 2], x3 = x[k + 3], *column = first + k * n;
#pragma GCC ivdep
      for (Eigen::Index i = 0; i < n; ++i)
        to[i] += (x0 * column[i] + x1 * column[n + i]) + (x2 * column[2 * n + i] + x3 * column[3 * n + i]);
    }
    for (; k < n_columns; ++k)
#pragma GCC ivdep
      for (Eigen::Index i = 0; i < n; ++i) to[i] += x[k] * first[k * n + i];
  });
  return sum;
}

}  // namespace

LayerModes::LayerModes(Eigen::MatrixXd shape_of_springs, Eigen::ArrayXd strength_of_modes)
    : shape(std::move(shape_of_springs)),
      strength(std::move(strength_of_modes)),
      pulled(shape * strength.matrix().asDiagonal()),
      at_springs(shape.transpose()) {
  for (Eigen::Index first = 0; first < shape.rows(); first += springs_of_block) {
    const Eigen::Index n = std::min(springs_of_block, shape.rows() - first);
    response_of_block_.emplace_back(shape.middleRows(first, n).transpose() * pulled.middleRows(first, n));
  }
}

Eigen::VectorXd LayerModes::shares_of(const Eigen::ArrayXd& load) const {
  return sum_of_columns(at_springs, load.data());
}

Eigen::ArrayXd LayerModes::coupling_of(const Eigen::VectorXd& share) const {
  return sum_of_columns(pulled, share.data()).array();
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
  return modes.coupling_of(modes.shares_of(load));
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
