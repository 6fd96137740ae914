#include "fem/full_contact/surface_operator.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "fem/support/dense.h"
#include "fem/support/solver_error.h"

namespace fretval::fem {

using Eigen::Index;

namespace {

/// The range of amplitudes, first to end, of one order and parity.
struct Group {
  Index first, end;
};

std::vector<Group> groups_of(const std::vector<Amplitude>& amplitudes) {
  std::vector<Group> groups;
  for (Index i = 0; i < static_cast<Index>(amplitudes.size()); ++i) {
    if (groups.empty() || !(amplitudes[groups.back().first].order == amplitudes[i].order)) groups.push_back({i, i});
    groups.back().end = i + 1;
  }
  return groups;
}

bool are_alike(const std::vector<Amplitude>& amplitudes, const Group& a, const Group& b) {
  if (amplitudes[a.first].order.n == 0 || amplitudes[a.first].order.n != amplitudes[b.first].order.n) return false;
  if (a.end - a.first != b.end - b.first) return false;
  for (Index i = 0; i < a.end - a.first; ++i)
    if (amplitudes[a.first + i].component != amplitudes[b.first + i].component) return false;
  return true;
}

/// Of the block of an order, the part between the amplitudes of two groups.
Eigen::MatrixXd block_between(const SurfaceCompliance& surface, const std::vector<Amplitude>& rows, const Group& some,
                              const std::vector<Amplitude>& columns, const Group& others) {
  const Index n = surface.n_rings();
  const auto& whole = surface.of(rows[some.first].order);
  Eigen::MatrixXd matrix((some.end - some.first) * n, (others.end - others.first) * n);
  for (Index i = some.first; i < some.end; ++i)
    for (Index j = others.first; j < others.end; ++j)
      matrix.block((i - some.first) * n, (j - others.first) * n, n, n) =
          whole.block(rows[i].component * n, columns[j].component * n, n, n);
  return matrix;
}

std::vector<OrderBlock> blocks_of(const SurfaceCompliance& surface, const std::vector<Amplitude>& amplitudes) {
  std::vector<OrderBlock> blocks;
  const auto groups = groups_of(amplitudes);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto& group = groups[i];
    blocks.push_back(
        {group.first, group.end - group.first, 1, block_between(surface, amplitudes, group, amplitudes, group)});
    if (i + 1 < groups.size() && are_alike(amplitudes, groups[i], groups[i + 1])) {
      blocks.back().n_copies = 2;
      ++i;
    }
  }
  return blocks;
}

Eigen::VectorXd diagonal_of(const Eigen::MatrixXd& transform, const std::vector<OrderBlock>& blocks, Index n_rings) {
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(n_rings, transform.rows());
  for (const auto& block : blocks)
    for (Index copy = 0; copy < block.n_copies; ++copy)
      for (Index i = 0; i < block.n_components; ++i)
        for (Index j = 0; j < block.n_components; ++j) {
          const Index first = block.first + copy * block.n_components;
          const auto weights = transform.col(first + i).cwiseProduct(transform.col(first + j));
          diagonal += block.matrix->block(i * n_rings, j * n_rings, n_rings, n_rings).diagonal() * weights.transpose();
        }
  return diagonal.rowwise().maxCoeff();
}

/// The amplitudes of a block as a matrix, with a column for each copy that it serves.
template <class Matrix>
Eigen::Map<Matrix> columns_of(Matrix& amplitudes, Index first, Index rows, Index n_copies = 1) {
  return {amplitudes.col(first).data(), rows, n_copies};
}

/// displaced <- the symmetric blocks times their amplitudes.
template <class Block, class Matrix>
void multiply_blocks(const std::vector<Block>& blocks, Matrix& amplitudes, Matrix& displaced) {
  for (const auto& block : blocks) {
    const Index rows = amplitudes.rows() * block.n_components;
    multiply_symmetric(block.matrix, columns_of(amplitudes, block.first, rows, block.n_copies),
                       columns_of(displaced, block.first, rows, block.n_copies));
  }
}

Eigen::MatrixXd transform_of(const std::vector<Amplitude>& amplitudes) {
  Eigen::MatrixXd transform(amplitudes.front().weights.size(), static_cast<Index>(amplitudes.size()));
  for (Index i = 0; i < transform.cols(); ++i) transform.col(i) = amplitudes[static_cast<std::size_t>(i)].weights;
  return transform;
}

void require_orders(const SurfaceCompliance& surface, const AngularGrid& grid) {
  if (surface.orders.size() <= grid.highest_order())
    throw std::invalid_argument(
        fmt::format("{} angles draw on Fourier orders up to {}, the compliance has them up to {}", grid.n_around,
                    grid.highest_order(), static_cast<int>(surface.orders.size()) - 1));
}

}  // namespace

SurfaceOperator::SurfaceOperator(const SurfaceCompliance& surface, const AngularGrid& grid, SurfaceField field)
    : grid_(grid), radii_(surface.radii), areas_(surface.areas * grid.multiplicity() / grid.n_around) {
  require_orders(surface, grid);
  const auto amplitudes = amplitudes_of(grid, field);
  transform_ = transform_of(amplitudes);
  blocks_ = blocks_of(surface, amplitudes);
  transposed_ = transform_.transpose();
  diagonal_ = diagonal_of(transform_, blocks_, n_rings());
}

SurfaceOperator SurfaceOperator::leading(Index n_rings) const {
  SurfaceOperator part = *this;
  const Index n = areas_.size();
  part.radii_.resize(static_cast<std::size_t>(n_rings) + 1);
  part.areas_ = areas_.head(n_rings);
  part.diagonal_ = diagonal_.head(n_rings);
  for (auto& block : part.blocks_) {
    Eigen::MatrixXd matrix(block.n_components * n_rings, block.n_components * n_rings);
    for (Index i = 0; i < block.n_components; ++i)
      for (Index j = 0; j < block.n_components; ++j)
        matrix.block(i * n_rings, j * n_rings, n_rings, n_rings) = block.matrix->block(i * n, j * n, n_rings, n_rings);
    block.matrix = SharedMatrix(std::move(matrix));
  }
  return part;
}

void SurfaceOperator::apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const {
  const Index n = n_rings();
  Eigen::MatrixXd amplitudes(n, transform_.cols()), displaced(n, transform_.cols());
  multiply(field, transform_, amplitudes);
  multiply_blocks(blocks_, amplitudes, displaced);
  result.resize(n, transform_.rows());
  multiply(displaced, transposed_, result);
}

CouplingOperator::CouplingOperator(const SurfaceCompliance& surface, const AngularGrid& grid) {
  require_orders(surface, grid);
  const auto tangential = amplitudes_of(grid, SurfaceField::tangential),
             normal = amplitudes_of(grid, SurfaceField::normal);
  tangential_ = transform_of(tangential);
  normal_ = transform_of(normal);
  tangential_transposed_ = tangential_.transpose();
  normal_transposed_ = normal_.transpose();
  for (const auto& along : groups_of(tangential))
    for (const auto& into : groups_of(normal))
      if (tangential[along.first].order == normal[into.first].order)
        blocks_.push_back({along.first, along.end - along.first, into.first,
                           block_between(surface, tangential, along, normal, into)});
}

Eigen::MatrixXd CouplingOperator::along_surface(const Eigen::MatrixXd& pressure) const {
  const Index n = pressure.rows();
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(n, 2 * pressure.cols());
  if (blocks_.empty()) return moved;
  Eigen::MatrixXd amplitudes(n, normal_.cols()), displaced = Eigen::MatrixXd::Zero(n, tangential_.cols());
  multiply(pressure, normal_, amplitudes);
  for (const auto& block : blocks_)
    multiply(block.matrix, amplitudes.col(block.normal),
             columns_of(displaced, block.tangential, n * block.n_components));
  multiply(displaced, tangential_transposed_, moved);
  return moved;
}

Eigen::MatrixXd CouplingOperator::into_body(const Eigen::MatrixXd& traction) const {
  const Index n = traction.rows();
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(n, traction.cols() / 2);
  if (blocks_.empty()) return moved;
  Eigen::MatrixXd amplitudes(n, tangential_.cols()), displaced = Eigen::MatrixXd::Zero(n, normal_.cols());
  multiply(traction, tangential_, amplitudes);
  for (const auto& block : blocks_)
    multiply_by_transpose(block.matrix, columns_of(amplitudes, block.tangential, n * block.n_components),
                          displaced.col(block.normal));
  multiply(displaced, normal_transposed_, moved);
  return moved;
}

// Harmonics are orthogonal on the angles, so the field of an amplitude is its row of T over the square of that. The
// highest harmonic of a traction is two amplitudes of which the angles only see the sum: half of it goes to each.
InverseOperator::InverseOperator(const SurfaceOperator& op, const Eigen::VectorXd& ground)
    : n_rings_(op.n_rings()), scale_(1 / op.diagonal().minCoeff()) {
  Eigen::MatrixXd fields = op.transform();
  const double n_points = op.grid().n_around / op.grid().multiplicity();
  for (Index i = 0; i < fields.cols(); ++i) fields.col(i) *= std::min(1 / fields.col(i).squaredNorm(), 2 * n_points);
  const Eigen::VectorXd tied = op.areas().cwiseProduct(ground);
  for (const auto& block : op.blocks()) {
    Eigen::MatrixXd matrix = block.matrix;
    for (Index i = 0; i < block.n_components; ++i)
      matrix.diagonal().segment(i * tied.size(), tied.size()) += fields.col(block.first + i).squaredNorm() * tied;
    auto inverted = inverse(std::move(matrix));
    if (!inverted) throw SolverError("a Fourier order of the contact compliance is not positive definite");
    blocks_.push_back({block.first, block.n_components, block.n_copies, (*inverted / scale_).cast<float>()});
  }
  fields_ = fields.cast<float>();
  transposed_ = fields_.transpose();
}

void InverseOperator::apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const {
  const double size = field.lpNorm<Eigen::Infinity>();
  if (size == 0) return void(result.setZero(field.rows(), field.cols()));
  const Index n = field.rows();
  Eigen::MatrixXf single = (field / size).cast<float>(), amplitudes(n_rings_, fields_.cols()),
                  solved(n_rings_, fields_.cols());
  multiply(single, fields_, amplitudes.topRows(n));
  amplitudes.bottomRows(n_rings_ - n).setZero();
  multiply_blocks(blocks_, amplitudes, solved);
  multiply(solved.topRows(n), transposed_, single);
  result = single.cast<double>() * (size * scale_);
}

}  // namespace fretval::fem
