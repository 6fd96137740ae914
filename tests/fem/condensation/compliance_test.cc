#include "fem/condensation/compliance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <tuple>
#include <utility>

#include "fem/condensation/condensation.h"
#include "fem/operators/stiffness.h"
#include "fem/support/constants.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/half_space.h"
#include "tests/fem/surface_response.h"

namespace fretval::fem::compliance_test {
namespace {

TEST(Compliance, IsSymmetricPositiveDefinite) {
  for (const FourierOrder order : {axisymmetric, lateral}) {
    const Eigen::MatrixXd& matrix = half_space(order, 64).compliance.matrix;
    EXPECT_LT((matrix - matrix.transpose()).cwiseAbs().maxCoeff(), 1e-14 * matrix.cwiseAbs().maxCoeff());
    EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues()[0], 0);
  }
}

// Second method: the whole system loaded by one ring, no Schur complement.
TEST(Compliance, IsTheResponseOfTheWholeBody) {
  const GridData grid = quarter_disc_grid(1, 8, 20, 0.25);
  for (const FourierOrder order : {axisymmetric, lateral}) {
    const HarmonicSpace space(grid, order, 3);
    const auto& line = space.contact_line();
    const SparseMatrix stiffness = assemble_stiffness(space);
    const Compliance compliance =
        contact_compliance(line, Condensation(stiffness, line.dofs, "body").schur_complement());
    const auto on_body = [&](Eigen::Index ring) {
      Eigen::VectorXd load = Eigen::VectorXd::Zero(stiffness.n);
      for (std::size_t i = 0; i < line.dofs.size(); ++i) load[line.dofs[i]] = line.loads(i, ring);
      return load;
    };
    for (const Eigen::Index j : {0, 3, 7}) {
      const Eigen::VectorXd u = solve_uncondensed(stiffness, on_body(j), "body");
      for (Eigen::Index i = 0; i < 8; ++i)
        EXPECT_NEAR((*compliance.matrix)(i, j), on_body(i).dot(u), 1e-12 * compliance.matrix->maxCoeff());
    }
  }
}

/// Displacement per unit uniform traction, averaged over the disc r < 1.
double mean_displacement(const ContactProblem& problem, unsigned n) {
  return problem.compliance.matrix->topLeftCorner(n, n).sum() / pi;
}

// Uniform pressure p on a disc of radius a: mean displacement 16 p a / (3 pi E*), E* = 4G (Johnson, Contact
// Mechanics, 3.4); uniform traction: the same with G* = 8G/3. No free boundary, but a logarithmic slope at r = a that
// leaves an error of h^2: 1.8e-5 at 16 rings, 1.1e-6 at 64.
TEST(Compliance, OfAUniformTractionIsExact) {
  for (const unsigned n : {16U, 64U}) {
    const double tolerance = 3e-5 * 256 / (n * n);
    EXPECT_NEAR(mean_displacement(normal_half_space(n), n) / (4 / (3 * pi)), 1, tolerance);
    EXPECT_NEAR(mean_displacement(tangential_half_space(n), n) / (2 / pi), 1, tolerance);
  }
}

// Both are the same body; they differ by the error of degree 2: 9.8e-5 at 16 rings, 2.4e-5 at 64.
TEST(Compliance, HardlyDependsOnTheDegree) {
  for (const FourierOrder order : {axisymmetric, lateral})
    for (const unsigned n : {16U, 32U}) {
      const double cubic = mean_displacement(half_space(order, n), n);
      const double quadratic = mean_displacement(half_space(order, n, 2), n);
      EXPECT_NEAR(quadratic / cubic, 1, 2e-3 / n);
      EXPECT_NE(quadratic, cubic);
    }
}

// What the point load at the far field misses decays like R^-3: 1.4e-4 at R = 5. From 20 on the mesh shows, 3e-6.
TEST(Compliance, HardlyDependsOnTheFarRadius) {
  for (const FourierOrder order : {axisymmetric, lateral}) {
    std::vector<double> displacement;
    for (const double far_radius : {5.0, 20.0, 40.0}) {
      const HarmonicSpace space(quarter_disc_grid(1, 16, far_radius, 0.15), order, 3);
      const auto compliance = contact_compliance(
          space.contact_line(),
          Condensation(assemble_stiffness(space), space.contact_line().dofs, "body").schur_complement());
      displacement.push_back(compliance.matrix->sum() / pi);
    }
    EXPECT_NEAR(displacement[0] / displacement[2], 1, 1e-3);
    EXPECT_NEAR(displacement[1] / displacement[2], 1, 1e-5);
  }
}

TEST(Compliance, CountsTheRingsWhoseMiddlesLieWithinARadius) {
  const Compliance rings{{0, 1, 2, 4}, Eigen::Vector3d(1, 3, 12), SharedMatrix(Eigen::MatrixXd::Identity(3, 3))};
  for (const auto& [radius, n] : {std::pair{0.4, 0}, {0.6, 1}, {2.9, 2}, {3.1, 3}, {100.0, 3}})
    EXPECT_EQ(rings_within(rings, radius), n) << radius;
}

TEST(Compliance, NeedsABodyThatIsHeld) {
  const GridData grid = quarter_disc_grid(1, 8, 6, 0.35);
  const HarmonicSpace space(grid, axisymmetric, 2);
  SparseMatrix upside_down = assemble_stiffness(space);
  for (double& value : upside_down.values) value = -value;
  const Condensation condensation(upside_down, space.contact_line().dofs, "body");
  expect_solver_error([&] { contact_compliance(space.contact_line(), condensation.schur_complement()); },
                      {"not positive definite", "not held"});
}

/// A layer of a Poisson's ratio, and its thickness over the radius of the disc.
class LayerOf : public testing::TestWithParam<std::tuple<double, double>> {
 protected:
  /// Of the integral of the displacement over a disc of radius 1 under a uniform traction, less 1.
  [[nodiscard]] double error(const FourierOrder& order, unsigned n_rings) const {
    const auto [nu, thickness] = GetParam();
    auto grid = layer_grid(1, n_rings, thickness, 0.3);
    grid.elasticity.poisson_ratio = nu;
    const HarmonicSpace space(grid, order, 3);
    const Condensation condensation(assemble_skeleton_stiffness(space), space.contact_line().dofs, "layer");
    const auto compliance = contact_compliance(space.contact_line(), condensation.schur_complement());
    const auto response = [&, nu = nu, thickness = thickness](double k) {
      const auto at = surface_response(k, nu, thickness);
      return order == axisymmetric ? at.normal : (at.along + at.across) / 2;
    };
    const double half_space_per_k = order == axisymmetric ? 1 - nu : (2 - nu) / 2;
    return compliance.matrix->sum() / disc_response(response, half_space_per_k, 1, thickness) - 1;
  }
};

INSTANTIATE_TEST_SUITE_P(Layers, LayerOf,
                         testing::Combine(testing::Values(0.0, 0.3, 0.45, 0.5), testing::Values(0.2, 1.0, 10.0)));

// The jump of the traction at the edge of the disc makes a logarithmic slope there, which elements follow with the
// second order of their size.
TEST_P(LayerOf, RespondsAsItsEquationsInFourierSpaceSay) {
  for (const auto& order : {axisymmetric, lateral}) {
    EXPECT_LT(std::abs(error(order, 8)), 4e-3) << order.n;
    EXPECT_LT(std::abs(error(order, 16)), 1e-3) << order.n;
  }
}

}  // namespace
}  // namespace fretval::fem::compliance_test
