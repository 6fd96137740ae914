#include "fem/condensation/far_field.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>

#include "fem/operators/harmonic_space_parts.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

bool is_far(const dealii::TriaAccessor<1, 2, 2>& face) {
  return face.at_boundary() && face.boundary_id() == static_cast<dealii::types::boundary_id>(BoundaryPart::far);
}

/// Amplitudes of a point force in a half-space z <= 0: displacement (U, W) times 4 pi G R, and the parts of the
/// stress that act on planes along the angle times 2 pi R^2. s and c: sine and cosine of the angle to the axis, which
/// points into the body. compressible: 1 - 2 nu.
struct PointForce {
  double u, w;
  double rr, rz, zz, rt;
};

/// Boussinesq's point force, along z, upwards.
PointForce boussinesq(double s, double c, double compressible) {
  return {-s * c + compressible * s / (1 + c),
          1 + compressible + c * c,
          3 * s * s * c - compressible / (1 + c),
          -3 * s * c * c,
          3 * c * c * c,
          0};
}

/// Cerruti's point force, along x.
PointForce cerruti(double s, double c, double compressible) {
  const double extra = compressible * s / ((1 + c) * (1 + c));
  return {1 + s * s + compressible * c / (1 + c),
          -s * c - compressible * s / (1 + c),
          -3 * s * s * s + extra,
          3 * s * s * c,
          -3 * s * c * c,
          extra};
}

/// What the far boundary lacks at a point: amplitudes along r, the angle and z, upwards.
std::array<double, 3> lacking(const PointForce& at, double radius, const dealii::Point<2>& x,
                              const dealii::Tensor<1, 2>& normal) {
  const double radial = (at.u * x[0] + at.w * x[1]) / radius, tilt = (normal * x) / radius;
  const double held = 3 * tilt * radial / (4 * pi * radius * radius * radius);
  const double scale = 1 / (2 * pi * radius * radius);
  return {scale * (at.rr * normal[0] + at.rz * normal[1]) + held * x[0], scale * at.rt * normal[0],
          scale * (at.rz * normal[0] + at.zz * normal[1]) + held * x[1]};
}

/// Work of the missing load on a unit displacement of a component: (U, W) or (s, m, W) with U = m + s, V = m - s.
double work_on(unsigned component, const FourierOrder& order, const std::array<double, 3>& load) {
  if (component == vertical_component(order)) return load[2];
  if (order.n == 0) return load[0];
  return load[0] + (component == 0 ? -load[1] : load[1]);
}

}  // namespace

bool lacks_far_field(const HarmonicSpace& space) {
  if (space.elasticity().poisson_ratio == 0.5 || space.order().n > 1 || space.order().is_torsion()) return false;
  for (const auto& cell : space.parts().dofs.active_cell_iterators())
    for (const unsigned face : cell->face_indices())
      if (is_far(*cell->face(face))) return true;
  return false;
}

Eigen::VectorXd far_residual(const HarmonicSpace& space) {
  const auto& parts = space.parts();
  const auto order = space.order();
  const double compressible = 1 - 2 * space.elasticity().poisson_ratio, angular_factor = order.n == 0 ? 2 * pi : pi;
  dealii::FEFaceValues<2> values(parts.element, dealii::QGauss<1>(parts.element.degree + 3),
                                 dealii::update_values | dealii::update_JxW_values | dealii::update_normal_vectors |
                                     dealii::update_quadrature_points);
  std::vector<dealii::types::global_dof_index> dofs(parts.element.n_dofs_per_cell());
  Eigen::VectorXd residual = Eigen::VectorXd::Zero(space.n_skeleton_dofs());
  for (const auto& cell : parts.dofs.active_cell_iterators())
    for (const unsigned face : cell->face_indices()) {
      if (!is_far(*cell->face(face))) continue;
      values.reinit(cell, face);
      cell->get_dof_indices(dofs);
      for (const unsigned q : values.quadrature_point_indices()) {
        const auto& x = values.quadrature_point(q);
        const double radius = x.norm(), s = x[0] / radius, c = -x[1] / radius;
        const auto force = order.n == 0 ? boussinesq(s, c, compressible) : cerruti(s, c, compressible);
        const auto load = lacking(force, radius, x, values.normal_vector(q));
        const double weight = angular_factor * x[0] * values.JxW(q);
        for (unsigned i = 0; i < dofs.size(); ++i) {
          const unsigned component = parts.element.system_to_component_index(i).first;
          if (component >= n_displacements(order) || !parts.element.has_support_on_face(i, face)) continue;
          if (parts.constraints.is_constrained(dofs[i])) continue;
          residual[static_cast<Eigen::Index>(dofs[i])] +=
              weight * work_on(component, order, load) * values.shape_value(i, q);
        }
      }
    }
  return residual;
}

void add_far_field(const HarmonicSpace& space, const Condensation& condensation,
                   const std::vector<unsigned>& components, Compliance& compliance) {
  if (!lacks_far_field(space)) return;
  const auto line = space.contact_line(components);
  const Eigen::VectorXd field = condensation.solve(far_residual(space));
  Eigen::VectorXd at_dofs(static_cast<Eigen::Index>(line.dofs.size()));
  for (Eigen::Index i = 0; i < at_dofs.size(); ++i) at_dofs[i] = field[line.dofs[static_cast<std::size_t>(i)]];
  const Eigen::VectorXd moved = line.loads.transpose() * at_dofs;
  // The force acts through one of the components: that of the ring contact.
  const unsigned pushed = ring_component(space.order());
  const auto place = std::find(components.begin(), components.end(), pushed) - components.begin();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(moved.size());
  if (place < static_cast<std::ptrdiff_t>(components.size()))
    force.segment(place * line.n_elements(), line.n_elements()) = line.areas;
  Eigen::MatrixXd matrix = *compliance.matrix;
  matrix += (moved * force.transpose() + force * moved.transpose()) / 2;
  compliance.matrix = SharedMatrix(std::move(matrix));
}

}  // namespace fretval::fem
