#include "fem/operators/strain_operator.h"

#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

constexpr unsigned n_strains = 6;

double angular_factor(const FourierOrder& order) {
  return order.n == 0 ? 2 * pi : pi;
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

// V of n = 0 alone.
StrainColumn torsional_strain(double value, const dealii::Tensor<1, 2>& grad, double r) {
  const double shear = 1 / std::sqrt(2.0);
  return {{0, 0, 0, 0, shear * (grad[0] - value / r), shear * grad[1]}, 0};
}

// n >= 1: component 0 is s, 1 is m, 2 is W; U = m + s, V = m - s.
StrainColumn higher_strain(unsigned n, unsigned component, double value, const dealii::Tensor<1, 2>& grad, double r) {
  const double shear = 1 / std::sqrt(2.0), inner = (1.0 - n) * value / r, outer = (1.0 + n) * value / r;
  switch (component) {
    case 0:
      return {{grad[0], inner, 0, shear * grad[1], shear * (inner - grad[0]), -shear * grad[1]}, grad[0] + inner};
    case 1:
      return {{grad[0], outer, 0, shear * grad[1], shear * (grad[0] - outer), shear * grad[1]}, grad[0] + outer};
    default:
      return {{0, 0, grad[1], shear * grad[0], 0, -shear * n * value / r}, grad[1]};
  }
}

StrainColumn strain_of(const FourierOrder& order, unsigned component, double value, const dealii::Tensor<1, 2>& grad,
                       double r) {
  if (order.n > 0) return higher_strain(order.n, component, value, grad, r);
  return order.is_torsion() ? torsional_strain(value, grad, r) : axisymmetric_strain(component, value, grad, r);
}

/// Displacement by a unit of a component in the direction of the far-field condition: along the normal of the
/// hemisphere, with U = m + s, or along the angle in torsion, where a point couple satisfies `t = -(3 G / R) u`.
double far_direction(const FourierOrder& order, unsigned component, const dealii::Point<2>& x) {
  if (order.is_torsion()) return 1;
  return x[component == vertical_component(order) ? 1 : 0] / x.norm();
}

}  // namespace

CellOperators::CellOperators(const HarmonicSpace& space)
    : order_(space.order()),
      values_(space.parts().element, dealii::QGauss<2>(space.parts().element.degree + 1),
              dealii::update_values | dealii::update_gradients | dealii::update_JxW_values |
                  dealii::update_quadrature_points),
      face_values_(space.parts().element, dealii::QGauss<1>(space.parts().element.degree + 1),
                   dealii::update_values | dealii::update_JxW_values | dealii::update_normal_vectors |
                       dealii::update_quadrature_points) {
  const auto& element = values_.get_fe();
  const unsigned n_components = n_displacements(order_);
  const auto n_points = values_.n_quadrature_points;
  for (unsigned node = 0; node < element.base_element(0).n_dofs_per_cell(); ++node)
    for (unsigned component = 0; component < n_components; ++component)
      displacement_shapes_.push_back(element.component_to_system_index(component, node));
  if (has_pressure(order_))
    for (unsigned node = 0; node < element.base_element(1).n_dofs_per_cell(); ++node)
      pressure_shapes_.push_back(element.component_to_system_index(n_components, node));
  const auto n_displacement = static_cast<Eigen::Index>(displacement_shapes_.size());
  strain_.resize(n_strains * n_points, n_displacement);
  divergence_.resize(n_points, n_displacement);
  pressure_.resize(n_points, static_cast<Eigen::Index>(pressure_shapes_.size()));
  far_.resize(0, n_displacement);
}

void CellOperators::evaluate(const dealii::DoFHandler<2>::active_cell_iterator& cell) {
  values_.reinit(cell);
  const unsigned n_components = n_displacements(order_);
  for (const unsigned q : values_.quadrature_point_indices()) {
    const double r = values_.quadrature_point(q)[0];
    const double weight = std::sqrt(angular_factor(order_) * r * values_.JxW(q));
    // All components of a node have the same shape.
    for (unsigned first = 0; first < displacement_shapes_.size(); first += n_components) {
      const double value = values_.shape_value(displacement_shapes_[first], q);
      const auto grad = values_.shape_grad(displacement_shapes_[first], q);
      for (unsigned component = 0; component < n_components; ++component) {
        const auto column = strain_of(order_, component, value, grad, r);
        for (unsigned k = 0; k < n_strains; ++k)
          strain_(n_strains * q + k, first + component) = std::sqrt(2.0) * weight * column.strain[k];
        divergence_(q, first + component) = weight * column.divergence;
      }
    }
    for (unsigned j = 0; j < pressure_shapes_.size(); ++j)
      pressure_(q, j) = weight * values_.shape_value(pressure_shapes_[j], q);
  }
  far_.resize(0, far_.cols());
  for (const unsigned face : cell->face_indices())
    if (cell->face(face)->at_boundary() &&
        cell->face(face)->boundary_id() == static_cast<dealii::types::boundary_id>(BoundaryPart::far)) {
      face_values_.reinit(cell, face);
      append_far_face();
    }
}

void CellOperators::append_far_face() {
  const Eigen::Index n_before = far_.rows();
  far_.conservativeResize(n_before + face_values_.n_quadrature_points, Eigen::NoChange);
  for (const unsigned q : face_values_.quadrature_point_indices()) {
    const auto x = face_values_.quadrature_point(q);
    const double radius = x.norm();
    // The point-load stress is purely radial, so on a chord of the arc the traction carries the cosine of the tilt.
    const double tilt = (face_values_.normal_vector(q) * x) / radius;
    const double weight = std::sqrt(angular_factor(order_) * x[0] * face_values_.JxW(q) * tilt * 3 / radius);
    for (unsigned j = 0; j < displacement_shapes_.size(); ++j) {
      const unsigned shape = displacement_shapes_[j], component = j % n_displacements(order_);
      far_(n_before + q, j) = weight * far_direction(order_, component, x) * face_values_.shape_value(shape, q);
    }
  }
}

}  // namespace fretval::fem
