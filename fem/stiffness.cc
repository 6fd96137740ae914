#include "fem/stiffness.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_matrix.h>

#include <cmath>

#include "fem/harmonic_space_parts.h"

namespace fretval::fem {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr unsigned n_strains = 6;

double angular_factor(Harmonic harmonic) {
  return harmonic == Harmonic::normal ? 2 * pi : pi;
}

/// Rows of the strain and divergence operators at one point, one column per shape function.
struct StrainColumn {
  std::array<double, n_strains>
      strain;  // rr, tt, zz, and the engineering shears divided by sqrt(2): strain . strain = eps:eps
  double divergence;
};

// n = 0: component 0 is U, 1 is W.
StrainColumn axisymmetric_strain(unsigned component, double value, const dealii::Tensor<1, 2>& grad, double r) {
  const double shear = 1 / std::sqrt(2.0);
  if (component == 0) return {{grad[0], value / r, 0, shear * grad[1], 0, 0}, grad[0] + value / r};
  return {{0, 0, grad[1], shear * grad[0], 0, 0}, grad[1]};
}

// n = 1: component 0 is s, 1 is m, 2 is W; U = m + s, V = m - s.
StrainColumn first_harmonic_strain(unsigned component, double value, const dealii::Tensor<1, 2>& grad, double r) {
  const double shear = 1 / std::sqrt(2.0);
  switch (component) {
    case 0:
      return {{grad[0], 0, 0, shear * grad[1], -shear * grad[0], -shear * grad[1]}, grad[0]};
    case 1:
      return {{grad[0], 2 * value / r, 0, shear * grad[1], shear * (grad[0] - 2 * value / r), shear * grad[1]},
              grad[0] + 2 * value / r};
    default:
      return {{0, 0, grad[1], shear * grad[0], 0, -shear * value / r}, grad[1]};
  }
}

/// Scratch of one cell: the strains of all quadrature points are stacked, so that the cell matrix is two matrix
/// products.
struct CellOperators {
  Eigen::MatrixXd strain, divergence, pressure;

  CellOperators(Eigen::Index n_points, Eigen::Index n_dofs)
      : strain(n_strains * n_points, n_dofs), divergence(n_points, n_dofs), pressure(n_points, n_dofs) {}

  void evaluate(const dealii::FEValues<2>& values, Harmonic harmonic) {
    strain.setZero();
    divergence.setZero();
    pressure.setZero();
    const auto& element = values.get_fe();
    const auto strain_of = harmonic == Harmonic::normal ? axisymmetric_strain : first_harmonic_strain;
    for (const unsigned q : values.quadrature_point_indices()) {
      const double r = values.quadrature_point(q)[0];
      const double weight = std::sqrt(angular_factor(harmonic) * r * values.JxW(q));
      for (unsigned i = 0; i < element.n_dofs_per_cell(); ++i) {
        const unsigned component = element.system_to_component_index(i).first;
        if (component == n_displacements(harmonic)) {
          pressure(q, i) = weight * values.shape_value(i, q);
          continue;
        }
        const auto column = strain_of(component, values.shape_value(i, q), values.shape_grad(i, q), r);
        for (unsigned k = 0; k < n_strains; ++k)
          strain(n_strains * q + k, i) = std::sqrt(2.0) * weight * column.strain[k];
        divergence(q, i) = weight * column.divergence;
      }
    }
  }

  [[nodiscard]] Eigen::MatrixXd matrix() const {
    const Eigen::MatrixXd coupling = divergence.transpose() * pressure;
    return strain.transpose() * strain - coupling - coupling.transpose();
  }
};

void add_far_field(const dealii::FEFaceValues<2>& values, Harmonic harmonic, Eigen::MatrixXd& matrix) {
  const auto& element = values.get_fe();
  Eigen::VectorXd normal_displacement(element.n_dofs_per_cell());
  for (const unsigned q : values.quadrature_point_indices()) {
    const auto x = values.quadrature_point(q);
    const double radius = x.norm();
    for (unsigned i = 0; i < element.n_dofs_per_cell(); ++i) {
      const unsigned component = element.system_to_component_index(i).first;
      const bool radial = component + 1 < n_displacements(harmonic);  // U, or both s and m: U = m + s
      const double n = radial ? x[0] / radius : component == vertical_component(harmonic) ? x[1] / radius : 0;
      normal_displacement[i] = n * values.shape_value(i, q);
    }
    // The point-load stress is purely radial, so on a chord of the arc the traction carries the cosine of the tilt.
    const double tilt = (values.normal_vector(q) * x) / radius;
    const double weight = angular_factor(harmonic) * x[0] * values.JxW(q) * tilt * 3 / radius;
    matrix += weight * normal_displacement * normal_displacement.transpose();
  }
}

SparseMatrix to_rows(const dealii::SparseMatrix<double>& matrix) {
  SparseMatrix rows;
  rows.n = static_cast<int>(matrix.m());
  rows.row_start.assign(1, 0);
  rows.columns.reserve(matrix.n_nonzero_elements());
  rows.values.reserve(matrix.n_nonzero_elements());
  std::vector<std::pair<int, double>> entries;
  for (int row = 0; row < rows.n; ++row) {
    entries.clear();
    for (auto it = matrix.begin(row); it != matrix.end(row); ++it)
      entries.emplace_back(static_cast<int>(it->column()), it->value());
    std::sort(entries.begin(), entries.end());  // deal.II stores the diagonal first
    for (const auto& [column, value] : entries) {
      rows.columns.push_back(column);
      rows.values.push_back(value);
    }
    rows.row_start.push_back(static_cast<int>(rows.columns.size()));
  }
  return rows;
}

}  // namespace

SparseMatrix assemble_stiffness(const HarmonicSpace& space) {
  const auto& parts = space.parts();
  const unsigned n_cell_dofs = parts.element.n_dofs_per_cell();
  dealii::DynamicSparsityPattern dynamic_pattern(parts.dofs.n_dofs());
  dealii::DoFTools::make_sparsity_pattern(parts.dofs, dynamic_pattern, parts.constraints, false);
  dealii::SparsityPattern pattern;
  pattern.copy_from(dynamic_pattern);
  dealii::SparseMatrix<double> matrix(pattern);

  const dealii::QGauss<2> quadrature(parts.element.degree + 1);
  dealii::FEValues<2> values(
      parts.element, quadrature,
      dealii::update_values | dealii::update_gradients | dealii::update_JxW_values | dealii::update_quadrature_points);
  dealii::FEFaceValues<2> face_values(parts.element, dealii::QGauss<1>(parts.element.degree + 1),
                                      dealii::update_values | dealii::update_JxW_values |
                                          dealii::update_normal_vectors | dealii::update_quadrature_points);
  CellOperators operators(quadrature.size(), n_cell_dofs);
  dealii::FullMatrix<double> cell_matrix(n_cell_dofs, n_cell_dofs);
  std::vector<dealii::types::global_dof_index> dofs(n_cell_dofs);
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    values.reinit(cell);
    operators.evaluate(values, space.harmonic());
    Eigen::MatrixXd dense = operators.matrix();
    for (const unsigned face : cell->face_indices())
      if (cell->face(face)->at_boundary() &&
          cell->face(face)->boundary_id() == static_cast<dealii::types::boundary_id>(BoundaryPart::far)) {
        face_values.reinit(cell, face);
        add_far_field(face_values, space.harmonic(), dense);
      }
    for (unsigned i = 0; i < n_cell_dofs; ++i)
      for (unsigned j = 0; j < n_cell_dofs; ++j) cell_matrix(i, j) = dense(i, j);
    cell->get_dof_indices(dofs);
    parts.constraints.distribute_local_to_global(cell_matrix, dofs, matrix);
  }
  return to_rows(matrix);
}

}  // namespace fretval::fem
