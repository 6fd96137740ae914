#include "fem/full_model/manufactured_solution.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <cmath>

#include "fem/condensation/condensation.h"
#include "fem/operators/harmonic_space_parts.h"
#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"

namespace fretval::fem {
namespace {

// The fields are smooth but no polynomials.
constexpr unsigned extra_points = 3;

/// (r, theta, z) amplitudes of the shape function of a component: U, W or s, m, W with U = m + s, V = m - s.
std::array<double, 3> direction_of(unsigned component, const FourierOrder& order) {
  if (component == vertical_component(order)) return {0, 0, 1};
  if (order == axisymmetric) return {1, 0, 0};
  return {1, component == 0 ? -1.0 : 1.0, 0};
}

/// What the boundary must carry at a point for the field to be in equilibrium, the far-field condition included.
std::array<double, 3> boundary_load(const StokesState& state, const dealii::Point<2>& x,
                                    const dealii::Tensor<1, 2>& normal, bool far) {
  std::array<double, 3> load{};
  for (std::size_t i = 0; i < 3; ++i) load[i] = state.stress[i][0] * normal[0] + state.stress[i][1] * normal[1];
  if (!far) return load;
  const double radius = x.norm(), tilt = (normal * x) / radius;
  const double robin = 3 / radius * tilt * (state.u * x[0] + state.w * x[1]) / radius;
  load[0] += robin * x[0] / radius;
  load[2] += robin * x[1] / radius;
  return load;
}

Eigen::VectorXd assemble_load(const HarmonicSpace& space, const StokesField& field) {
  const auto& parts = space.parts();
  const FourierOrder order = space.order();
  const double angular_factor = order == axisymmetric ? 2 * pi : pi;
  dealii::FEFaceValues<2> values(parts.element, dealii::QGauss<1>(parts.element.degree + extra_points),
                                 dealii::update_values | dealii::update_JxW_values | dealii::update_normal_vectors |
                                     dealii::update_quadrature_points);
  const unsigned n_cell_dofs = parts.element.n_dofs_per_cell();
  std::vector<dealii::types::global_dof_index> dofs(n_cell_dofs);
  dealii::Vector<double> load(space.n_dofs()), cell_load(n_cell_dofs);
  for (const auto& cell : parts.dofs.active_cell_iterators())
    for (const unsigned face : cell->face_indices()) {
      if (!cell->face(face)->at_boundary()) continue;
      const auto part = static_cast<BoundaryPart>(cell->face(face)->boundary_id());
      if (part == BoundaryPart::axis) continue;
      values.reinit(cell, face);
      cell_load = 0;
      for (const unsigned q : values.quadrature_point_indices()) {
        const auto& x = values.quadrature_point(q);
        const auto at_point = boundary_load(field(x[0], x[1]), x, values.normal_vector(q), part == BoundaryPart::far);
        for (unsigned i = 0; i < n_cell_dofs; ++i) {
          const unsigned component = parts.element.system_to_component_index(i).first;
          if (component == n_displacements(order)) continue;
          const auto direction = direction_of(component, order);
          double work = 0;
          for (std::size_t k = 0; k < 3; ++k) work += at_point[k] * direction[k];
          cell_load[i] += angular_factor * x[0] * values.JxW(q) * work * values.shape_value(i, q);
        }
      }
      cell->get_dof_indices(dofs);
      parts.constraints.distribute_local_to_global(cell_load, dofs, load);
    }
  return Eigen::Map<const Eigen::VectorXd>(load.begin(), space.n_dofs());
}

/// U, V, W and P at a point, and the weight of its volume.
struct Sample {
  Eigen::Vector3d displacement;
  double pressure;
  double r, z, weight;
};

std::vector<Sample> samples_of(const HarmonicSpace& space, const Eigen::VectorXd& solution) {
  const auto& parts = space.parts();
  const FourierOrder order = space.order();
  dealii::FEValues<2> values(parts.element, dealii::QGauss<2>(parts.element.degree + extra_points),
                             dealii::update_values | dealii::update_JxW_values | dealii::update_quadrature_points);
  dealii::Vector<double> dof_values(solution.begin(), solution.end());
  std::vector<dealii::Vector<double>> at_points(values.n_quadrature_points,
                                                dealii::Vector<double>(parts.element.n_components()));
  std::vector<Sample> samples;
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    values.reinit(cell);
    values.get_function_values(dof_values, at_points);
    for (const unsigned q : values.quadrature_point_indices()) {
      Sample sample{Eigen::Vector3d::Zero(), at_points[q][n_displacements(order)], values.quadrature_point(q)[0],
                    values.quadrature_point(q)[1], values.quadrature_point(q)[0] * values.JxW(q)};
      for (unsigned component = 0; component < n_displacements(order); ++component) {
        const auto direction = direction_of(component, order);
        sample.displacement += at_points[q][component] * Eigen::Vector3d(direction[0], direction[1], direction[2]);
      }
      samples.push_back(sample);
    }
  }
  return samples;
}

/// Takes a rotation about y out of the displacements, the one nearest to them in the L2 norm.
void remove_rotation(std::vector<Sample>& samples) {
  // u_x = z, u_z = -x.
  const auto rotation = [](const Sample& s) { return Eigen::Vector3d(s.z, -s.z, -s.r); };
  double product = 0, square = 0;
  for (const auto& s : samples) {
    product += s.weight * rotation(s).dot(s.displacement);
    square += s.weight * rotation(s).squaredNorm();
  }
  for (auto& s : samples) s.displacement -= product / square * rotation(s);
}

}  // namespace

StokesField point_force(const FourierOrder& order, double height) {
  return [=](double r, double z_body) {
    const double z = z_body - height, R = std::hypot(r, z), R3 = R * R * R;
    const double along = order == axisymmetric ? z : r;  // amplitude of x.F
    StokesState state{};
    state.u = r * along / R3 / (8 * pi);
    state.w = z * along / R3 / (8 * pi);
    if (order == axisymmetric) {
      state.w += 1 / R / (8 * pi);
    } else {
      state.u += 1 / R / (8 * pi);
      state.v = -1 / R / (8 * pi);
    }
    state.pressure = along / R3 / (4 * pi);
    const double factor = -3 * along / (4 * pi * R3 * R * R);
    state.stress = {{{factor * r * r, factor * r * z}, {0, 0}, {factor * r * z, factor * z * z}}};
    return state;
  };
}

BulkError bulk_error(const HarmonicSpace& space, const StokesField& load, const StokesField& exact) {
  const Eigen::VectorXd solution =
      solve_uncondensed(assemble_stiffness(space), assemble_load(space, load), "manufactured solution");
  auto samples = samples_of(space, solution);
  double displacement_norm = 0, pressure_norm = 0;
  for (auto& s : samples) {
    const auto state = exact(s.r, s.z);
    const Eigen::Vector3d displacement(state.u, state.v, state.w);
    displacement_norm += s.weight * displacement.squaredNorm();
    pressure_norm += s.weight * state.pressure * state.pressure;
    s.displacement -= displacement;
    s.pressure -= state.pressure;
  }
  if (space.order() == lateral) remove_rotation(samples);
  BulkError error{0, 0};
  for (const auto& s : samples) {
    error.displacement += s.weight * s.displacement.squaredNorm();
    error.pressure += s.weight * s.pressure * s.pressure;
  }
  return {std::sqrt(error.displacement / displacement_norm), std::sqrt(error.pressure / pressure_norm)};
}

}  // namespace fretval::fem
