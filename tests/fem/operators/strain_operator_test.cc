#include "fem/operators/strain_operator.h"

#include <deal.II/fe/mapping_q1.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "fem/support/constants.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::strain_operator_test {
namespace {

/// A field of every component: (U, W, P) or (s, m, W, P) at (r, z).
using Field = std::function<std::array<double, 4>(double r, double z)>;

/// A frustum of a cone, radii 1 above and 1/2 below, height 1, as one cell whose flank is the far boundary.
constexpr double frustum_volume = pi / 3 * (1 + 0.5 + 0.25);
GridData frustum() {
  return {{{0, -1}, {0.5, -1}, {1, 0}, {0, 0}},
          {{0, 1, 2, 3}},
          {{{0, 1}, BoundaryPart::free},
           {{1, 2}, BoundaryPart::far},
           {{2, 3}, BoundaryPart::contact},
           {{3, 0}, BoundaryPart::axis}}};
}

Eigen::VectorXd cell_values(const HarmonicSpace& space, const dealii::DoFHandler<2>::active_cell_iterator& cell,
                            const Field& field) {
  const auto& element = space.parts().element;
  Eigen::VectorXd values(element.n_dofs_per_cell());
  for (unsigned i = 0; i < element.n_dofs_per_cell(); ++i) {
    const auto x = dealii::MappingQ1<2>().transform_unit_to_real_cell(cell, element.unit_support_point(i));
    values[i] = field(x[0], x[1]).at(element.system_to_component_index(i).first);
  }
  return values;
}

/// Integrals over the frustum of a field that it holds exactly: 2 eps:eps, (div u)^2, P div u, P^2.
struct Integrals {
  double strain, divergence, divergence_pressure, pressure;
};

Integrals integrals_of(const FourierOrder& order, const Field& field) {
  const HarmonicSpace space(frustum(), order, 2);
  CellOperators operators(space);
  const auto cell = space.parts().dofs.begin_active();
  operators.evaluate(cell);
  const Eigen::VectorXd values = cell_values(space, cell, field), u = values(operators.displacement_shapes());
  const Eigen::VectorXd divergence = operators.divergence() * u,
                        pressure = operators.pressure() * values(operators.pressure_shapes());
  return {(operators.strain() * u).squaredNorm(), divergence.squaredNorm(), divergence.dot(pressure),
          pressure.squaredNorm()};
}

/// Roundoff: the quadrature is exact for strains that are constant.
constexpr double roundoff = 1e-13;

// u = (x, y, z) a: eps = a 1, div u = 3 a. With P = 2.
TEST(StrainOperator, OfUniformExpansion) {
  const auto of = integrals_of(axisymmetric, [](double r, double z) {
    return std::array<double, 4>{0.7 * r, 0.7 * z, 2};
  });
  EXPECT_NEAR(of.strain, 2 * 3 * 0.49 * frustum_volume, roundoff);
  EXPECT_NEAR(of.divergence, 9 * 0.49 * frustum_volume, roundoff);
  EXPECT_NEAR(of.divergence_pressure, 3 * 0.7 * 2 * frustum_volume, roundoff);
  EXPECT_NEAR(of.pressure, 4 * frustum_volume, roundoff);
}

// Shears u_x = b z and u_z = c x, eps_xz = (b + c)/2; a rotation has none.
TEST(StrainOperator, OfShearAndRotation) {
  for (const auto& [b, c] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}) {
    const auto of = integrals_of(lateral, [b = b, c = c](double r, double z) {
      return std::array<double, 4>{b * z, 0, c * r, 0};
    });
    EXPECT_NEAR(of.strain, (b + c) * (b + c) * frustum_volume, roundoff);
    EXPECT_NEAR(of.divergence, 0, roundoff);
  }
}

// u_x = x^2 - y^2, u_y = 2 x y, that is s = 0, m = r^2: eps_xx = eps_yy = 2x, eps_xy = y - y = 0. And u_x = x^2 + y^2,
// s = r^2, m = 0: eps_xx = 2x, eps_xy = y. int x^2 dV = int y^2 dV = (pi/4) int R^4 dz = (pi/20) (1 - 1/32)/(1/2).
TEST(StrainOperator, OfBothHorizontalComponents) {
  const double moment = pi / 20 * (1 - 1.0 / 32) * 2;
  const auto of_m = integrals_of(lateral, [](double r, double) { return std::array<double, 4>{0, r * r, 0, 0}; });
  EXPECT_NEAR(of_m.strain, 2 * (4 + 4) * moment, roundoff);
  EXPECT_NEAR(of_m.divergence, 16 * moment, roundoff);
  const auto of_s = integrals_of(lateral, [](double r, double) { return std::array<double, 4>{r * r, 0, 0, 0}; });
  EXPECT_NEAR(of_s.strain, 2 * (4 + 2) * moment, roundoff);
  EXPECT_NEAR(of_s.divergence, 4 * moment, roundoff);
}

// u = x: u.n = R on the arc, int (3/R) R^2 dA = 6 pi R^3. Its chords lie inside by h^2/(8 R^2), 0.3 % in the mean (see
// StiffnessOfDegree), which counts thrice.
TEST(StrainOperator, FarFieldResistsAlongTheRadius) {
  constexpr double far_radius = 6;
  const HarmonicSpace space(quarter_disc_grid(1, 8, far_radius, 0.35), axisymmetric, 2);
  CellOperators operators(space);
  double work = 0;
  for (const auto& cell : space.parts().dofs.active_cell_iterators()) {
    operators.evaluate(cell);
    const Eigen::VectorXd values = cell_values(space, cell, [](double r, double z) {
      return std::array<double, 4>{r, z, 0, 0};
    });
    work += (operators.far() * values(operators.displacement_shapes())).squaredNorm();
  }
  EXPECT_NEAR(work / (6 * pi * std::pow(far_radius, 3)), 1, 0.02);
}

}  // namespace
}  // namespace fretval::fem::strain_operator_test
