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
  for (const auto& group : groups_of(amplitudes)) {
    const auto alike = std::find_if(blocks.begin(), blocks.end(), [&](const OrderBlock& block) {
      return are_alike(amplitudes, {block.first, block.first + block.n_components}, group);
    });
    if (alike == blocks.end())
      blocks.push_back(
          {group.first, group.end - group.first, block_between(surface, amplitudes, group, amplitudes, group)});
    else
      alike->to_copy = group.first - alike->first;
  }
  return blocks;
}

Eigen::VectorXd diagonal_of(const std::vector<Amplitude>& amplitudes, const std::vector<OrderBlock>& blocks,
                            Index n_rings) {
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(n_rings, amplitudes.front().weights.size());
  for (const auto& block : blocks)
    for (Index copy = 0; copy < block.n_copies(); ++copy)
      for (Index i = 0; i < block.n_components; ++i)
        for (Index j = 0; j < block.n_components; ++j) {
          const auto first = amplitudes.begin() + block.first + copy * block.to_copy;
          const auto weights = first[i].weights.cwiseProduct(first[j].weights);
          diagonal += block.matrix->block(i * n_rings, j * n_rings, n_rings, n_rings).diagonal() * weights.transpose();
        }
  return diagonal.rowwise().maxCoeff();
}

/// Amplitudes from the first one on as a vector of this many rows, and a second one `to_copy` amplitudes later unless
/// that is 0.
template <class Matrix>
Eigen::Map<Matrix, Eigen::Unaligned, Eigen::OuterStride<>> columns_of(Matrix& amplitudes, Index first, Index rows,
                                                                      Index to_copy = 0) {
  return {amplitudes.col(first).data(), rows, to_copy == 0 ? 1 : 2,
          Eigen::OuterStride<>(std::max(to_copy * amplitudes.rows(), rows))};
}

/// displaced <- the symmetric blocks times their amplitudes.
template <class Block, class Matrix>
void multiply_blocks(const std::vector<Block>& blocks, Matrix& amplitudes, Matrix& displaced) {
  for (const auto& block : blocks) {
    const Index rows = amplitudes.rows() * block.n_components;
    multiply_symmetric(block.matrix, columns_of(amplitudes, block.first, rows, block.to_copy),
                       columns_of(displaced, block.first, rows, block.to_copy));
  }
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
  transform_ = {grid, field, amplitudes};
  blocks_ = blocks_of(surface, amplitudes);
  diagonal_ = diagonal_of(amplitudes, blocks_, n_rings());
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
  Eigen::MatrixXd amplitudes(n_rings(), transform_.n_amplitudes()), displaced(n_rings(), transform_.n_amplitudes());
  transform_.amplitudes_of(field, amplitudes);
  multiply_blocks(blocks_, amplitudes, displaced);
  transform_.field_of(displaced, result);
}

CouplingOperator::CouplingOperator(const SurfaceCompliance& surface, const AngularGrid& grid) {
  require_orders(surface, grid);
  const auto tangential = amplitudes_of(grid, SurfaceField::tangential),
             normal = amplitudes_of(grid, SurfaceField::normal);
  tangential_ = {grid, SurfaceField::tangential, tangential};
  normal_ = {grid, SurfaceField::normal, normal};
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
  Eigen::MatrixXd amplitudes(n, normal_.n_amplitudes()),
      displaced = Eigen::MatrixXd::Zero(n, tangential_.n_amplitudes());
  normal_.amplitudes_of(pressure, amplitudes);
  for (const auto& block : blocks_)
    multiply(block.matrix, amplitudes.col(block.normal),
             columns_of(displaced, block.tangential, n * block.n_components));
  tangential_.field_of(displaced, moved);
  return moved;
}

Eigen::MatrixXd CouplingOperator::into_body(const Eigen::MatrixXd& traction) const {
  const Index n = traction.rows();
  Eigen::MatrixXd moved = Eigen::MatrixXd::Zero(n, traction.cols() / 2);
  if (blocks_.empty()) return moved;
  Eigen::MatrixXd amplitudes(n, tangential_.n_amplitudes()),
      displaced = Eigen::MatrixXd::Zero(n, normal_.n_amplitudes());
  tangential_.amplitudes_of(traction, amplitudes);
  for (const auto& block : blocks_)
    multiply_by_transpose(block.matrix, columns_of(amplitudes, block.tangential, n * block.n_components),
                          displaced.col(block.normal));
  normal_.field_of(displaced, moved);
  return moved;
}

// Harmonics are orthogonal on the angles, so the field of an amplitude is its row of T over the square of that. The
// highest harmonic of a traction is two amplitudes of which the angles only see the sum: half of it goes to each.
InverseOperator::InverseOperator(const SurfaceOperator& op, const Eigen::VectorXd& ground)
    : n_rings_(op.n_rings()), scale_(1 / op.diagonal().minCoeff()) {
  const double n_points = op.grid().n_around / op.grid().multiplicity();
  const Eigen::VectorXd squares = op.transform().squares(), factors = squares.cwiseInverse().cwiseMin(2 * n_points);
  const Eigen::VectorXd tied = op.areas().cwiseProduct(ground);
  for (const auto& block : op.blocks()) {
    Eigen::MatrixXd matrix = block.matrix;
    for (Index i = 0; i < block.n_components; ++i)
      matrix.diagonal().segment(i * tied.size(), tied.size()) +=
          factors[block.first + i] * factors[block.first + i] * squares[block.first + i] * tied;
    auto inverted = inverse(std::move(matrix));
    if (!inverted) throw SolverError("a Fourier order of the contact compliance is not positive definite");
    blocks_.push_back({block.first, block.n_components, block.to_copy, (*inverted / scale_).cast<float>()});
  }
  fields_ = op.transform().scaled(factors);
}

void InverseOperator::apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const {
  const double size = field.lpNorm<Eigen::Infinity>();
  if (size == 0) return void(result.setZero(field.rows(), field.cols()));
  const Index n = field.rows();
  Eigen::MatrixXf single = (field / size).cast<float>(), amplitudes(n_rings_, fields_.n_amplitudes()),
                  solved(n_rings_, fields_.n_amplitudes());
  fields_.amplitudes_of(std::move(single), amplitudes.topRows(n));
  amplitudes.bottomRows(n_rings_ - n).setZero();
  multiply_blocks(blocks_, amplitudes, solved);
  fields_.field_of(solved.topRows(n), single);
  result = single.cast<double>() * (size * scale_);
}

}  // namespace fretval::fem
