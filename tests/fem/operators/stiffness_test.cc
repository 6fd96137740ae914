#include "fem/operators/stiffness.h"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/mapping_q1.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>

#include "fem/operators/harmonic_space_parts.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/random_vector.h"

namespace fretval::fem::stiffness_test {
namespace {

constexpr double far_radius = 6;

/// Coarse, and as irregular as gmsh makes it.
const GridData& grid() {
  static const GridData grid = quarter_disc_grid(1, 8, far_radius, 0.35);
  return grid;
}

GridData grid_of(double poisson_ratio) {
  auto compressible = grid();
  compressible.elasticity.poisson_ratio = poisson_ratio;
  return compressible;
}

struct Dof {
  unsigned component;
  double r, z;
  bool near_far;  // in a cell with a corner on the far arc
  bool near_pin;  // in a cell with the far end of the surface
};

std::vector<Dof> dofs_of(const HarmonicSpace& space) {
  const auto& parts = space.parts();
  std::vector<dealii::Point<2>> support(space.n_dofs());
  dealii::DoFTools::map_dofs_to_support_points(dealii::MappingQ1<2>(), parts.dofs, support);
  std::vector<Dof> dofs(space.n_dofs());
  std::vector<dealii::types::global_dof_index> indices(parts.element.n_dofs_per_cell());
  for (const auto& cell : parts.dofs.active_cell_iterators()) {
    bool near_far = false, near_pin = false;
    for (const unsigned v : cell->vertex_indices()) {
      near_far = near_far || cell->vertex(v).norm() > far_radius * (1 - 1e-9);
      near_pin = near_pin || cell->vertex(v)[0] > far_radius * (1 - 1e-9);
    }
    cell->get_dof_indices(indices);
    for (unsigned i = 0; i < indices.size(); ++i) {
      Dof& dof = dofs[indices[i]];
      dof.component = parts.element.system_to_component_index(i).first;
      dof.r = support[indices[i]][0];
      dof.z = support[indices[i]][1];
      dof.near_far = dof.near_far || near_far;
      dof.near_pin = dof.near_pin || near_pin;
    }
  }
  return dofs;
}

/// A field of every component: (U, W, P) or (s, m, W, P) at (r, z).
using Field = std::function<std::array<double, 4>(double r, double z)>;

struct Body {
  HarmonicSpace space;
  SparseMatrix stiffness;
  std::vector<Dof> dofs;

  Body(const FourierOrder& order, unsigned degree, double poisson_ratio = 0.5)
      : space(grid_of(poisson_ratio), order, degree), stiffness(assemble_stiffness(space)), dofs(dofs_of(space)) {}

  [[nodiscard]] Eigen::VectorXd interpolate(const Field& field) const {
    Eigen::VectorXd u(stiffness.n);
    for (int i = 0; i < stiffness.n; ++i) u[i] = field(dofs[i].r, dofs[i].z).at(dofs[i].component);
    return u;
  }

  [[nodiscard]] Eigen::VectorXd force(const Eigen::VectorXd& u) const { return multiply(stiffness, u); }

  /// Largest force on the chosen dofs, relative to the largest sum of its terms over all dofs: roundoff is 1e-15.
  [[nodiscard]] double largest_force(const Eigen::VectorXd& u, const std::function<bool(const Dof&)>& chosen) const {
    const Eigen::VectorXd f = force(u);
    SparseMatrix sizes = stiffness;
    for (double& value : sizes.values) value = std::abs(value);
    const Eigen::VectorXd terms = multiply(sizes, u.cwiseAbs());
    double largest = 0, scale = 0;
    int n_chosen = 0;
    for (int row = 0; row < stiffness.n; ++row) {
      scale = std::max(scale, terms[row]);
      if (!chosen(dofs[row])) continue;
      largest = std::max(largest, std::abs(f[row]));
      ++n_chosen;
    }
    EXPECT_GT(n_chosen, 200);
    return largest / scale;
  }
};

constexpr double roundoff = 1e-13;

bool inside(const Dof& dof) {
  return !dof.near_far && dof.z < 0;
}

bool inside_or_on_surface(const Dof& dof) {
  return !dof.near_far;
}

class StiffnessOfDegree : public testing::TestWithParam<unsigned> {
 protected:
  Body normal_{axisymmetric, GetParam()};
  Body tangential_{lateral, GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Degrees, StiffnessOfDegree, testing::Values(2U, 3U));

// A rigid motion meets the far-field condition alone, whose energy is int (3/R) (u.n)^2 dA = 3 R (2 pi/3) for a unit
// translation and a hemisphere. The chords lie inside the arc by h^2/(8 R^2) with h = 0.15 R to 0.35 R: 0.3 % measured.
TEST_P(StiffnessOfDegree, TranslationsAreResistedByTheFarFieldAlone) {
  const Eigen::VectorXd down = normal_.interpolate([](double, double) { return std::array<double, 4>{0, 1, 0, 0}; });
  const Eigen::VectorXd along = tangential_.interpolate([](double, double) {
    return std::array<double, 4>{1, 0, 0, 0};
  });
  EXPECT_LT(normal_.largest_force(down, inside_or_on_surface), roundoff);
  EXPECT_LT(tangential_.largest_force(along, inside_or_on_surface), roundoff);
  EXPECT_NEAR(down.dot(normal_.force(down)) / (2 * pi * far_radius), 1, 0.006);
  EXPECT_NEAR(along.dot(tangential_.force(along)) / (2 * pi * far_radius), 1, 0.006);
}

// u.n = 0 on the hemisphere: no force even there, but next to the pin that holds the rotation.
TEST_P(StiffnessOfDegree, RotationIsNotResisted) {
  const Eigen::VectorXd u = tangential_.interpolate([](double r, double z) {
    return std::array<double, 4>{z, 0, -r, 0};
  });
  EXPECT_LT(tangential_.largest_force(u, [](const Dof& dof) { return !dof.near_pin; }), roundoff);
}

// U = r, W = -2z: strains (1, 1, -2); with P = -4 the surface is free of traction.
TEST_P(StiffnessOfDegree, UniformCompressionIsReproduced) {
  const Eigen::VectorXd u = normal_.interpolate([](double r, double z) {
    return std::array<double, 4>{r, -2 * z, -4, 0};
  });
  EXPECT_LT(normal_.largest_force(u, inside_or_on_surface), roundoff);
}

// The same strains with P = 0: sigma_zz = -4 loads the contact line like a uniform traction, ring by ring.
TEST_P(StiffnessOfDegree, LoadsOfTheContactLineAreThoseOfAUniformPressure) {
  const Eigen::VectorXd f = normal_.force(normal_.interpolate([](double r, double z) {
    return std::array<double, 4>{r, -2 * z, 0, 0};
  }));
  const auto& line = normal_.space.contact_line();
  const Eigen::VectorXd loads = line.loads.rowwise().sum();
  for (std::size_t i = 0; i + 1 < line.dofs.size(); ++i)  // the last dof is also loaded from outside the line
    EXPECT_NEAR(f[line.dofs[i]], -4 * loads[static_cast<Eigen::Index>(i)], 1e-13);
}

// Shear u_x = z: sigma_xz = 1, a uniform traction along x on the contact line.
TEST_P(StiffnessOfDegree, LoadsOfTheContactLineAreThoseOfAUniformTraction) {
  const Eigen::VectorXd u = tangential_.interpolate([](double, double z) { return std::array<double, 4>{z, 0, 0, 0}; });
  EXPECT_LT(tangential_.largest_force(u, inside), roundoff);
  const Eigen::VectorXd f = tangential_.force(u);
  const auto& line = tangential_.space.contact_line();
  const Eigen::VectorXd loads = line.loads.rowwise().sum();
  for (std::size_t i = 0; i + 1 < line.dofs.size(); ++i)
    EXPECT_NEAR(f[line.dofs[i]], loads[static_cast<Eigen::Index>(i)], 1e-13);
}

// Shear u_z = x: the other half of the rotation.
TEST_P(StiffnessOfDegree, VerticalShearIsReproduced) {
  const Eigen::VectorXd u = tangential_.interpolate([](double r, double) { return std::array<double, 4>{0, 0, r, 0}; });
  EXPECT_LT(tangential_.largest_force(u, inside), roundoff);
}

// Q_k contains quadratic polynomials on straight-edged cells. n = 0: U = r z, W = -z^2, P = -2z (Stokes: grad P =
// Laplacian of u = -2 e_z), sigma_zz = 0 at the surface.
TEST_P(StiffnessOfDegree, QuadraticStokesFieldIsReproducedForTheNormalHarmonic) {
  const Eigen::VectorXd u = normal_.interpolate([](double r, double z) {
    return std::array<double, 4>{r * z, -z * z, -2 * z, 0};
  });
  EXPECT_LT(normal_.largest_force(u, inside), roundoff);
}

// n = 1, with every operator at work: u_x = x^2 - y^2 + b (x^2 + y^2) + c z^2, u_y = 2 x y, u_z = -(4 + 2b) x z is free
// of divergence, and its Laplacian (4b + 2c) e_x is the gradient of P = (4b + 2c) x. With c = -(4 + 4b) sigma_zz
// vanishes at the surface. In harmonics: s = b r^2 + c z^2, m = r^2, W = -(4 + 2b) r z, P = (4b + 2c) r.
TEST_P(StiffnessOfDegree, QuadraticStokesFieldIsReproducedForTheTangentialHarmonic) {
  const double b = 0.3, c = -4 - 4 * b;
  const Eigen::VectorXd u = tangential_.interpolate([&](double r, double z) {
    return std::array<double, 4>{b * r * r + c * z * z, r * r, -(4 + 2 * b) * r * z, (4 * b + 2 * c) * r};
  });
  EXPECT_LT(tangential_.largest_force(u, inside_or_on_surface), roundoff);
}

// The tests above must be able to fail: fields out of equilibrium or with a divergence give 1e-4 of the terms.
TEST_P(StiffnessOfDegree, FieldOutOfEquilibriumIsNoticed) {
  const Eigen::VectorXd compressed = normal_.interpolate([](double r, double z) {
    return std::array<double, 4>{r, -1.9 * z, -4, 0};
  });
  EXPECT_GT(normal_.largest_force(compressed, inside), 1e-5);
  const Eigen::VectorXd warped = tangential_.interpolate([](double r, double) {
    return std::array<double, 4>{0, r * r, 0, 0};
  });
  EXPECT_GT(tangential_.largest_force(warped, inside), 1e-5);
}

/// Poisson's ratio.
class Compressible : public testing::TestWithParam<double> {
 protected:
  double nu_ = GetParam(), lambda_ = 2 * nu_ / (1 - 2 * nu_), shift_ = 2 * (1 - 2 * nu_) / 3;
};

INSTANTIATE_TEST_SUITE_P(PoissonRatios, Compressible, testing::Values(0.0, 0.3, 0.49));

// U = r, W = b z with sigma_zz = lambda (2 + b) + 2 b = 0; P = -(lambda + c) div u.
TEST_P(Compressible, UniformCompressionIsReproduced) {
  const double b = -2 * lambda_ / (lambda_ + 2), pressure = -(lambda_ + shift_) * (2 + b);
  const Body body(axisymmetric, 2, nu_);
  EXPECT_LT(body.largest_force(body.interpolate([&](double r, double z) {
    return std::array<double, 4>{r, b * z, pressure, 0};
  }),
                               inside_or_on_surface),
            roundoff);
}

// Papkovich and Neuber's 2 u = 4 (1 - nu) h e_z - grad(z h) with the harmonic h = z r^n cos(n theta), n = 2 and, with
// cubic elements at its highest degree, 1: U = -n z^2 r^(n-1)/2 = -V, W = (1 - 2 nu) z r^n, div u = (1 - 2 nu) r^n.
TEST_P(Compressible, PapkovichNeuberFieldsAreReproduced) {
  for (const unsigned n : {1U, 2U}) {
    const Body body({n, Parity::even}, 3, nu_);
    const auto u = body.interpolate([&](double r, double z) {
      const double power = n == 1 ? r : r * r, s = -0.5 * n * z * z * (n == 1 ? 1 : r), rest = 1 - 2 * nu_;
      return std::array<double, 4>{s, 0, rest * z * power, -(lambda_ + shift_) * rest * power};
    });
    EXPECT_LT(body.largest_force(u, inside), roundoff) << n;
  }
}

// Gradients of harmonic functions have no divergence and no Laplacian, whatever Poisson's ratio is. Of z r^n cos(n
// theta): U = n z r^(n-1) = -V, W = r^n. Of (z^2 - r^2/(2n+2)) r^n cos(n theta): s = n r^(n-1) z^2 - r^(n+1)/2, m =
// -r^(n+1)/(2n+2), W = 2 z r^n.
TEST_P(Compressible, GradientsOfHarmonicFunctionsAreReproducedForHigherOrders) {
  for (const unsigned n : {2U, 3U}) {
    const Body body({n, Parity::even}, 3, nu_);
    const auto power = [](double r, unsigned k) { return k == 1 ? r : k == 2 ? r * r : r * r * r; };
    const auto u = body.interpolate([&](double r, double z) {
      return std::array<double, 4>{n * z * power(r, n - 1), 0, power(r, n), 0};
    });
    EXPECT_LT(body.largest_force(u, inside), roundoff) << n;
  }
  const Body body({2, Parity::even}, 3, nu_);
  const auto u = body.interpolate([](double r, double z) {
    return std::array<double, 4>{2 * r * z * z - r * r * r / 2, -r * r * r / 6, 2 * z * r * r, 0};
  });
  EXPECT_LT(body.largest_force(u, inside), roundoff);
  const auto wrong = body.interpolate([](double r, double z) {
    return std::array<double, 4>{2 * r * z * z - r * r * r / 2, r * r * r / 6, 2 * z * r * r, 0};
  });
  EXPECT_GT(body.largest_force(wrong, inside), 1e-5);
}

// V = r z is a torsion without forces inside, as is V = r z^2 - r^3/4, which leaves the surface free of traction; a
// rotation, V = r, meets the far-field condition alone: int (3/R) r^2 dA = 4 pi R^3.
TEST(Torsion, IsReproduced) {
  const Body body({0, Parity::odd}, 3);
  EXPECT_LT(body.largest_force(body.interpolate([](double r, double z) {
    return std::array<double, 4>{r * z, 0, 0, 0};
  }),
                               inside),
            roundoff);
  EXPECT_LT(body.largest_force(body.interpolate([](double r, double z) {
    return std::array<double, 4>{r * z * z - r * r * r / 4, 0, 0, 0};
  }),
                               inside_or_on_surface),
            roundoff);
  const Eigen::VectorXd turn = body.interpolate([](double r, double) { return std::array<double, 4>{r, 0, 0, 0}; });
  EXPECT_LT(body.largest_force(turn, inside_or_on_surface), roundoff);
  EXPECT_NEAR(turn.dot(body.force(turn)) / (4 * pi * std::pow(far_radius, 3)), 1, 0.01);
}

// It changes no volume.
TEST(Torsion, DoesNotKnowPoissonsRatio) {
  testing::internal::CaptureStderr();
  const Body incompressible({0, Parity::odd}, 3), compressible({0, Parity::odd}, 3, 0.2);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "BLAS complains there";
  EXPECT_EQ(incompressible.stiffness.values, compressible.stiffness.values);
}

// A body twice as stiff needs twice the forces, and cells count by themselves: those of a half that is stiffer.
TEST(Moduli, MultiplyTheStiffness) {
  for (const double nu : {0.5, 0.3}) {
    auto stiff = grid_of(nu);
    stiff.elasticity.moduli.assign(stiff.cells.size(), 2);
    const HarmonicSpace one(grid_of(nu), axisymmetric, 2), two(stiff, axisymmetric, 2);
    const auto dofs = dofs_of(one);
    Eigen::VectorXd u = random_vector(static_cast<int>(one.n_dofs()), 1), twice = u;
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      if (one.parts().constraints.is_constrained(i)) u[i] = twice[i] = 0;
      if (dofs[i].component == 2) twice[i] *= 2;  // the pressure
    }
    const Eigen::VectorXd expected = multiply(assemble_stiffness(one), u),
                          found = multiply(assemble_stiffness(two), twice);
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      if (dofs[i].near_far) continue;
      EXPECT_NEAR(found[i], (dofs[i].component == 2 ? 1 : 2) * expected[i], 1e-12) << i;
    }
  }
}

TEST_P(StiffnessOfDegree, IsAnUpperTriangleWhoseRowsBeginWithTheirDiagonal) {
  for (const Body* body : {&normal_, &tangential_}) {
    const auto& k = body->stiffness;
    for (int row = 0; row < k.n; ++row) {
      EXPECT_EQ(k.columns[k.row_start[row]], row);
      EXPECT_TRUE(std::is_sorted(&k.columns[k.row_start[row]], &k.columns[k.row_start[row + 1] - 1] + 1));
    }
  }
}

TEST_P(StiffnessOfDegree, ConstrainedRowsHoldTheirDiagonalAlone) {
  for (const Body* body : {&normal_, &tangential_}) {
    const auto& constraints = body->space.parts().constraints;
    EXPECT_GT(constraints.n_constraints(), 10U);
    const auto& k = body->stiffness;
    for (int row = 0; row < k.n; ++row)
      for (int i = k.row_start[row]; i < k.row_start[row + 1]; ++i) {
        const bool constrained = constraints.is_constrained(row) || constraints.is_constrained(k.columns[i]);
        if (!constrained) continue;
        if (k.columns[i] == row)
          EXPECT_GT(k.values[i], 0);
        else
          EXPECT_EQ(k.values[i], 0);
      }
  }
}

/// Harmonic and degree.
class SkeletonOf : public testing::TestWithParam<std::tuple<FourierOrder, unsigned>> {
 protected:
  HarmonicSpace space_{grid(), std::get<0>(GetParam()), std::get<1>(GetParam())};
  SparseMatrix whole_ = assemble_stiffness(space_), skeleton_ = assemble_skeleton_stiffness(space_);
};

INSTANTIATE_TEST_SUITE_P(HarmonicsAndDegrees, SkeletonOf,
                         testing::Combine(testing::Values(axisymmetric, lateral), testing::Values(2U, 3U, 4U)));

TEST_P(SkeletonOf, LeavesOutTheNodesInsideCells) {
  const auto [order, degree] = GetParam();
  const unsigned n_inside = n_displacements(order) * (degree - 1) * (degree - 1) + (degree - 2) * (degree - 2);
  EXPECT_EQ(space_.n_dofs() - space_.n_skeleton_dofs(), n_inside * grid().cells.size());
  EXPECT_EQ(skeleton_.n, static_cast<int>(space_.n_skeleton_dofs()));
  EXPECT_LT(skeleton_.values.size(), whole_.values.size());
}

// S u_s are the forces on the skeleton, and there are none inside the cells, whatever moves the skeleton. Roundoff of
// the terms of a row.
TEST_P(SkeletonOf, ExtendsIntoTheCellsWithoutForcesThere) {
  Eigen::VectorXd moved = random_vector(skeleton_.n, 1);
  for (int i = 0; i < skeleton_.n; ++i)
    if (space_.parts().constraints.is_constrained(i)) moved[i] = 0;
  const Eigen::VectorXd field = extend_into_cells(space_, moved);
  EXPECT_EQ(field.head(skeleton_.n), moved);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(whole_.n);
  expected.head(skeleton_.n) = multiply(skeleton_, moved);
  EXPECT_LT((multiply(whole_, field) - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
}

// Roundoff of another order of the sums; each share by itself lacks most of the cells.
TEST_P(SkeletonOf, IsTheSumOfItsShares) {
  const Eigen::VectorXd moved = random_vector(skeleton_.n, 1), expected = multiply(skeleton_, moved);
  for (const unsigned count : {2U, 5U}) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(skeleton_.n);
    for (unsigned number = 0; number < count; ++number) {
      const auto share = assemble_skeleton_stiffness(space_, {number, count});
      EXPECT_LT(share.values.size(), skeleton_.values.size());
      sum += multiply(share, moved);
    }
    EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-13 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_P(SkeletonOf, HasANegativeDiagonalAtThePressures) {
  const auto dofs = dofs_of(space_);
  for (int i = 0; i < skeleton_.n; ++i) {
    const bool free_pressure =
        dofs[i].component == n_displacements(space_.order()) && !space_.parts().constraints.is_constrained(i);
    EXPECT_EQ(skeleton_.values[skeleton_.row_start[i]] < 0, free_pressure) << i;
    if (free_pressure) {
      EXPECT_EQ(whole_.values[whole_.row_start[i]], 0);
    }
  }
}

}  // namespace
}  // namespace fretval::fem::stiffness_test
