#include "fem/ring_contact/effective_radii.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "fem/ring_contact/wider_rings.h"
#include "fem/support/shared_matrix.h"
#include "tests/fem/convergence.h"
#include "tests/fem/half_space.h"
#include "tests/fem/stiffened_half_space.h"

namespace fretval::fem::effective_radii_test {
namespace {

using Eigen::Index;

// beta belongs to the discretisation of the edge alone, so it is the same on every mesh and for every radius: 0.099 to
// 0.114 measured, in either harmonic.
TEST(EffectiveRadii, AreShortOfTheRingsByAConstantFractionOfARing) {
  for (const FourierOrder order : {axisymmetric, lateral})
    for (const unsigned n : {16U, 32U, 64U}) {
      const auto& compliance = half_space(order, n).compliance;
      const Eigen::VectorXd radii = effective_radii(compliance).radius;
      EXPECT_EQ(radii[0], 0);
      double lowest = 1, highest = 0;
      for (Index m = 4; m <= compliance.areas.size(); ++m) {
        const double beta = static_cast<double>(m) - radii[m] * n;
        lowest = std::min(lowest, beta);
        highest = std::max(highest, beta);
      }
      EXPECT_GT(lowest, 0.095);
      EXPECT_LT(highest, 0.12);
    }
}

// The definition: force of the punch over a force per radius, which is 8 G d for a half-space (docs/theory.md); 1e-3
// off at 32 rings, h^2.
TEST(EffectiveRadii, AreProportionalToThePunchForce) {
  const auto& compliance = normal_half_space(32).compliance;
  const Eigen::VectorXd radii = effective_radii(compliance).radius;
  std::vector<double> per_radius;
  for (const Index m : {1, 9, 20, 36}) {
    const Eigen::VectorXd areas = compliance.areas.head(m);
    per_radius.push_back(areas.dot(compliance.matrix->topLeftCorner(m, m).llt().solve(areas)) / radii[m]);
  }
  for (const double value : per_radius) EXPECT_NEAR(value, per_radius[0], 1e-10);
  EXPECT_NEAR(per_radius[0], 8, 2e-3);
}

// A body that is held far away goes down by less everywhere, in proportion to the force; its contacts are as large. A
// punch is stiffened by 3.8 % (normal) and 2.5 %; 2e-2 off if that were taken for its radius.
TEST(EffectiveRadii, KnowAFarBoundary) {
  for (const FourierOrder order : {axisymmetric, lateral})
    for (const unsigned n : {16U, 32U, 64U}) {
      auto compliance = half_space(order, n).compliance;
      const Eigen::VectorXd radii = effective_radii(compliance).radius;
      const Eigen::VectorXd areas = compliance.areas;
      compliance.matrix = SharedMatrix(*compliance.matrix - 0.0045 * areas * areas.transpose());
      const auto [held, of_rings, scatter, calibration] = effective_radii(compliance);
      EXPECT_LT((held - radii).cwiseAbs().tail(radii.size() - 4).maxCoeff(), 0.3 / (n * n * n)) << n;
      EXPECT_LT(scatter, 1e-6);
      EXPECT_EQ(calibration, 0);
    }
}

/// The innermost rings of a body.
Compliance innermost(const Compliance& compliance, Index n) {
  return {std::vector<double>(compliance.radii.begin(), compliance.radii.begin() + n + 1), compliance.areas.head(n),
          SharedMatrix(Eigen::MatrixXd(compliance.matrix->topLeftCorner(n, n)))};
}

// A half-space of few rings, whose law has two terms more, against one of 72 that knows each of its own radii. The
// three terms of a half-space put the same edges 3e-4 (40 rings) and 2e-3 of a ring (20) elsewhere.
TEST(EffectiveRadii, OfAnotherBodyFollowTheLawOfFewRings) {
  constexpr double ring = 1.0 / 64, own_fit = 1e-4 * ring;  // 1e-6 of the force per radius, 72 rings out
  for (const FourierOrder order : {axisymmetric, lateral})
    for (const auto& [n_known, most] : {std::pair{40, 3e-4}, {20, 8e-4}}) {
      auto body = half_space(order, 64).compliance;
      const Eigen::VectorXd own = effective_radii(body).radius;
      body.half_space = std::make_shared<const Compliance>(innermost(body, n_known));
      const auto [radius, of_rings, scatter, calibration] = effective_radii(body);
      EXPECT_LT((radius - own).cwiseAbs().maxCoeff(), calibration + own_fit) << n_known;
      EXPECT_GT(calibration, scatter);
      EXPECT_LT(calibration, most * ring) << n_known;
    }
}

// Edges of discs lie further out than on a half-space by the second order of the rings, which puts the force of a
// punch 1.4e-3, 3.5e-4 and 9e-5 off; pairs of rings tell by how much.
TEST(EffectiveRadii, OfAnotherBodyAreOfThirdOrder) {
  std::vector<double> errors;
  for (const unsigned n : {16U, 32U, 64U}) {
    const StiffenedHalfSpace body(n);
    const Eigen::VectorXd radii = effective_radii(body.compliance()).radius;
    const Eigen::VectorXd areas = body.compliance().areas.head(n);
    const double force = areas.dot(body.compliance().matrix->topLeftCorner(n, n).llt().solve(areas));
    errors.push_back(std::abs(force / body.punch_force(radii[n]) - 1));
  }
  EXPECT_GT(observed_order(errors), 2.5);
  EXPECT_LT(errors[2], 2e-6);
}

// The pairs of rings, and what the same function says of them as rings of their own.
TEST(EffectiveRadii, OfWiderRingsAreThoseOfTheSameBody) {
  const StiffenedHalfSpace body(64);
  const auto wide = with_wider_rings(body.compliance());
  const auto known = effective_radii(body.compliance(), wide).wide.radius;
  EXPECT_LT((known - effective_radii(wide).radius).cwiseAbs().maxCoeff(), 1e-4 / 32);
}

}  // namespace
}  // namespace fretval::fem::effective_radii_test
