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

bool is_normal(const Amplitude& amplitude) {
  return !amplitude.order.is_torsion() && amplitude.component == vertical_component(amplitude.order);
}

OrderBlock block_of(const SurfaceCompliance& surface, const std::vector<Amplitude>& amplitudes, const Group& group,
                    bool coupling) {
  const Index n = surface.n_rings(), n_components = group.end - group.first;
  const auto& whole = surface.of(amplitudes[group.first].order);
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n_components * n, n_components * n);
  for (Index i = 0; i < n_components; ++i) {
    const auto& row = amplitudes[group.first + i];
    for (Index j = 0; j < n_components; ++j) {
      const auto& column = amplitudes[group.first + j];
      if (is_normal(row) != is_normal(column) && !coupling) continue;
      matrix.block(i * n, j * n, n, n) = whole.block(row.component * n, column.component * n, n, n);
    }
  }
  return {group.first, n_components, 1, std::move(matrix)};
}

std::vector<OrderBlock> blocks_of(const SurfaceCompliance& surface, const std::vector<Amplitude>& amplitudes,
                                  bool coupling) {
  std::vector<OrderBlock> blocks;
  const auto groups = groups_of(amplitudes);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    blocks.push_back(block_of(surface, amplitudes, groups[i], coupling));
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
Eigen::Map<Eigen::MatrixXd> columns_of(Eigen::MatrixXd& amplitudes, Index first, Index rows, Index n_copies) {
  return {amplitudes.col(first).data(), rows, n_copies};
}

}  // namespace

SurfaceOperator::SurfaceOperator(const SurfaceCompliance& surface, const AngularGrid& grid, Fields fields,
                                 bool coupling)
    : grid_(grid), radii_(surface.radii), areas_(surface.areas * grid.multiplicity() / grid.n_around) {
  if (surface.orders.size() <= grid.highest_order())
    throw std::invalid_argument(
        fmt::format("{} angles draw on Fourier orders up to {}, the compliance has them up to {}", grid.n_around,
                    grid.highest_order(), static_cast<int>(surface.orders.size()) - 1));
  const auto amplitudes = amplitudes_of(grid, fields);
  transform_.resize(amplitudes.front().weights.size(), static_cast<Index>(amplitudes.size()));
  for (Index i = 0; i < transform_.cols(); ++i) transform_.col(i) = amplitudes[static_cast<std::size_t>(i)].weights;
  blocks_ = blocks_of(surface, amplitudes, coupling);
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
  for (const auto& block : blocks_) {
    const Index rows = n * block.n_components;
    multiply(block.matrix, columns_of(amplitudes, block.first, rows, block.n_copies),
             columns_of(displaced, block.first, rows, block.n_copies));
  }
  result.resize(n, transform_.rows());
  multiply(displaced, transposed_, result);
}

// Harmonics are orthogonal on the angles, so the field of an amplitude is its row of T over the square of that. The
// highest harmonic of a traction is two amplitudes of which the angles only see the sum: half of it goes to each.
InverseOperator::InverseOperator(const SurfaceOperator& op, const Eigen::VectorXd& ground) : fields_(op.transform()) {
  const double n_points = op.grid().n_around / op.grid().multiplicity();
  for (Index i = 0; i < fields_.cols(); ++i) fields_.col(i) *= std::min(1 / fields_.col(i).squaredNorm(), 2 * n_points);
  const Eigen::VectorXd tied = op.areas().cwiseProduct(ground);
  for (const auto& block : op.blocks()) {
    Eigen::MatrixXd matrix = block.matrix;
    for (Index i = 0; i < block.n_components; ++i)
      matrix.diagonal().segment(i * tied.size(), tied.size()) += fields_.col(block.first + i).squaredNorm() * tied;
    auto inverted = inverse(std::move(matrix));
    if (!inverted) throw SolverError("a Fourier order of the contact compliance is not positive definite");
    blocks_.push_back({block.first, block.n_components, block.n_copies, SharedMatrix(std::move(*inverted))});
  }
  transposed_ = fields_.transpose();
}

void InverseOperator::apply(const Eigen::MatrixXd& field, Eigen::MatrixXd& result) const {
  Eigen::MatrixXd amplitudes(field.rows(), fields_.cols()), solved(field.rows(), fields_.cols());
  multiply(field, fields_, amplitudes);
  for (const auto& block : blocks_) {
    const Index rows = field.rows() * block.n_components;
    multiply(block.matrix, columns_of(amplitudes, block.first, rows, block.n_copies),
             columns_of(solved, block.first, rows, block.n_copies));
  }
  result.resize(field.rows(), fields_.rows());
  multiply(solved, transposed_, result);
}

}  // namespace fretval::fem
