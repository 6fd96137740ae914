#include "fem/ring_contact/effective_radii.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "fem/support/shared_matrix.h"
#include "tests/fem/half_space.h"

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
      const auto [held, scatter] = effective_radii(compliance);
      EXPECT_LT((held - radii).cwiseAbs().tail(radii.size() - 4).maxCoeff(), 0.3 / (n * n * n)) << n;
      EXPECT_LT(scatter, 1e-6);
    }
}

}  // namespace
}  // namespace fretval::fem::effective_radii_test
