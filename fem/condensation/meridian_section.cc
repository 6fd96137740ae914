#include "fem/condensation/meridian_section.h"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/vector.h>

#include <cmath>
#include <memory>

#include "fem/condensation/vtu_file.h"
#include "fem/operators/harmonic_space_parts.h"
#include "fem/operators/stiffness.h"

namespace fretval::fem {
namespace {

using Gradients = std::vector<dealii::Tensor<1, 2>>;

/// Amplitudes of a harmonic at theta = 0, z down.
struct Amplitudes {
  double u_r = 0, u_z = 0, rr = 0, tt = 0, zz = 0, rz = 0, pressure = 0;
};

/// u / r, also on the axis, where u vanishes.
double hoop(double u, double slope, double r) {
  return r > 0 ? u / r : slope;
}

// Strain amplitudes at a point: of the normal harmonic, whose U and W count inwards and down, or of the tangential one,
// whose displacements count outwards and up.
Amplitudes strains_of(const FourierOrder& order, const dealii::Vector<double>& x, const Gradients& d, double r) {
  Amplitudes at;
  if (order == axisymmetric) {
    at.rr = -d[0][0];
    at.tt = -hoop(x[0], d[0][0], r);
    at.zz = -d[1][1];
    at.rz = (d[0][1] + d[1][0]) / 2;
    at.pressure = -x[2];
  } else {
    at.rr = d[0][0] + d[1][0];
    at.tt = 2 * hoop(x[1], d[1][0], r);
    at.zz = d[2][1];
    at.rz = -(d[0][1] + d[1][1] + d[2][0]) / 2;
    at.pressure = x[3];
  }
  return at;
}

void set_displacements(const FourierOrder& order, const dealii::Vector<double>& x, Amplitudes& at) {
  const bool normal = order == axisymmetric;
  at.u_r = normal ? -x[0] : x[0] + x[1];
  at.u_z = normal ? x[1] : -x[2];
}

/// Turns strains into stresses. The mean volume change follows the pressure, and the deviation of single points from it
/// is removed.
void set_stresses(Amplitudes& at, double mean_stress) {
  const double mean = (at.rr + at.tt + at.zz) / 3;
  at.pressure *= mean_stress;
  for (double* stress : {&at.rr, &at.tt, &at.zz}) *stress = 2 * (*stress - mean) - at.pressure;
  at.rz *= 2;
}

/// Evaluates a harmonic at the points of a patch for each cell.
class HarmonicSampler {
 public:
  HarmonicSampler(const HarmonicState& state, const dealii::Quadrature<2>& points)
      : order_(state.space.order()),
        mean_stress_(compressibility(state.space.elasticity().poisson_ratio).mean_stress),
        moved_(state.moved.begin(), state.moved.end()),
        stressed_(state.stressed.begin(), state.stressed.end()),
        values_(state.space.parts().element, points,
                dealii::update_values | dealii::update_gradients | dealii::update_quadrature_points),
        x_(points.size(), dealii::Vector<double>(state.space.parts().element.n_components())),
        d_(points.size(), Gradients(state.space.parts().element.n_components())),
        amplitudes_(points.size()) {}

  const std::vector<Amplitudes>& at(const dealii::DoFHandler<2>::active_cell_iterator& cell) {
    values_.reinit(cell);
    values_.get_function_values(stressed_, x_);
    values_.get_function_gradients(stressed_, d_);
    for (std::size_t q = 0; q < x_.size(); ++q)
      amplitudes_[q] = strains_of(order_, x_[q], d_[q], values_.quadrature_point(q)[0]);
    values_.get_function_values(moved_, x_);
    for (std::size_t q = 0; q < x_.size(); ++q) {
      set_stresses(amplitudes_[q], mean_stress_);
      set_displacements(order_, x_[q], amplitudes_[q]);
    }
    return amplitudes_;
  }

 private:
  FourierOrder order_;
  double mean_stress_;
  dealii::Vector<double> moved_, stressed_;
  dealii::FEValues<2> values_;
  std::vector<dealii::Vector<double>> x_;
  std::vector<Gradients> d_;
  std::vector<Amplitudes> amplitudes_;
};

/// Amplitudes of both harmonics at theta = 0 (side 1) or pi (side -1).
Amplitudes sum_of(const Amplitudes& a, const Amplitudes& b, double side) {
  return {
      a.u_r + side * b.u_r, a.u_z + side * b.u_z,          a.rr + side * b.rr, a.tt + side * b.tt, a.zz + side * b.zz,
      a.rz + side * b.rz,   a.pressure + side * b.pressure};
}

const std::vector<Field>& section_fields() {
  static const std::vector<Field> fields{
      {"displacement (m)", 3}, {"stress (Pa)", 9}, {"pressure (Pa)", 1}, {"von Mises stress (Pa)", 1}};
  return fields;
}

void set_values(const Amplitudes& at, double side, const FieldUnits& units, unsigned q, Patch& patch) {
  const double xx = at.rr, yy = at.tt, zz = at.zz, xz = side * at.rz;
  const double differences = std::pow(xx - yy, 2) + std::pow(yy - zz, 2) + std::pow(zz - xx, 2);
  const double mises = std::sqrt(differences / 2 + 3 * xz * xz);
  const double d = units.depth, p = units.pressure;
  unsigned c = 0;
  for (const double value : {d * side * at.u_r, 0.0, d * at.u_z, p * xx, 0.0, p * xz, 0.0, p * yy, 0.0, p * xz, 0.0,
                             p * zz, p * at.pressure, p * mises})
    patch.data(c++, q) = static_cast<float>(value);
}

Patch patch_of(const dealii::DoFHandler<2>::active_cell_iterator& cell, double side, double length, unsigned degree) {
  constexpr unsigned n_components = 3 + 9 + 1 + 1;
  Patch patch = new_patch(degree, n_components);
  for (const unsigned v : cell->vertex_indices()) {
    const auto& corner = cell->vertex(v);
    patch.vertices[v] = {side * length * corner[0], 0, -length * corner[1]};
  }
  return patch;
}

}  // namespace

void write_meridian_section(const BodyState& state, const FieldUnits& units, std::ostream& stream) {
  const auto& parts = state.normal.space.parts();
  const unsigned degree = parts.element.degree;
  const dealii::QIterated<2> points(dealii::QTrapezoid<1>(), degree);
  HarmonicSampler normal(state.normal, points);
  const auto tangential = state.tangential ? std::make_unique<HarmonicSampler>(*state.tangential, points) : nullptr;
  const std::vector<Amplitudes> nothing(points.size());
  std::vector<Patch> patches;
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    const auto& a = normal.at(cell);
    // The normal and the tangential harmonic have the same cells in the same order.
    const auto& b = tangential ? tangential->at({&state.tangential->space.parts().triangulation, cell->level(),
                                                 cell->index(), &state.tangential->space.parts().dofs})
                               : nothing;
    for (const double side : {1.0, -1.0}) {
      Patch patch = patch_of(cell, side, units.length, degree);
      for (unsigned q = 0; q < points.size(); ++q) set_values(sum_of(a[q], b[q], side), side, units, q, patch);
      patch.patch_index = static_cast<unsigned>(patches.size());
      patches.push_back(std::move(patch));
    }
  }
  write_vtu(patches, section_fields(), stream);
}

}  // namespace fretval::fem
