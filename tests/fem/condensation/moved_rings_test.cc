#include "fem/condensation/moved_rings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace fretval::fem {
namespace {

std::vector<double> equal_radii(int n, double ring) {
  std::vector<double> radii;
  for (int i = 0; i <= n; ++i) radii.push_back(i * ring);
  return radii;
}

/// The integral of a power of the radius over each ring.
Eigen::VectorXd integrals(const std::vector<double>& radii, int power) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(radii.size()) - 1);
  for (Eigen::Index i = 0; i < all.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    all[i] = 2 * M_PI * (std::pow(radii[k + 1], power + 2) - std::pow(radii[k], power + 2)) / (power + 2);
  }
  return all;
}

/// A half-space has no length: over the areas, any kernel of the dimension 1/length.
Compliance half_space(const std::vector<double>& radii) {
  const Eigen::VectorXd areas = integrals(radii, 0);
  Eigen::MatrixXd matrix = areas * areas.transpose();
  for (Eigen::Index i = 0; i < areas.size(); ++i)
    for (Eigen::Index j = 0; j < areas.size(); ++j)
      matrix(i, j) /= radii[static_cast<std::size_t>(i) + 1] + radii[static_cast<std::size_t>(j) + 1];
  return {radii, areas, SharedMatrix(matrix)};
}

/// With the kernel -(1 - (r^2 + r'^2)/(3 H^2) + (r r')^2/(5 H^4))/H of a base at the depth H = 2 in addition.
Compliance layer(const std::vector<double>& radii) {
  constexpr double H = 2;
  auto body = half_space(radii);
  const Eigen::VectorXd areas = body.areas, squares = integrals(radii, 2);
  const Eigen::MatrixXd crossed = squares * areas.transpose(),
                        kernel = areas * areas.transpose() - (crossed + crossed.transpose()) / (3 * H * H) +
                                 squares * squares.transpose() / (5 * std::pow(H, 4));
  body.half_space = std::make_shared<const Compliance>(body);
  body.matrix = SharedMatrix(Eigen::MatrixXd(*body.matrix - kernel / H));
  return body;
}

// On the same body, of which only rings of the usual width are known, and coarse ones.
TEST(MovedRings, AreThoseOfTheSameBody) {
  const auto coarse = layer(equal_radii(8, 0.15));
  for (const auto& radii : {equal_radii(20, 0.06), std::vector<double>{0, 0.2, 0.5, 0.55, 0.6, 0.7, 1, 1.3}})
    for (const double factor : {0.97, 1.04}) {
      auto wider = radii;
      for (double& radius : wider) radius *= factor;
      const auto expected = layer(wider), moved = moved_rings(layer(radii), coarse, factor);
      EXPECT_EQ(moved.radii, wider);
      EXPECT_LT((moved.areas - expected.areas).norm(), 1e-14 * expected.areas.norm());
      EXPECT_LT((*moved.matrix - *expected.matrix).norm(), 1e-11 * expected.matrix->norm());
      EXPECT_LT((*moved.half_space->matrix - *expected.half_space->matrix).norm(), 1e-14 * expected.matrix->norm());
    }
}

// Six coarse rings at least, with the half-space of each.
TEST(MovedRings, WantAHalfSpaceOfEnoughRings) {
  const auto body = layer(equal_radii(20, 0.06));
  EXPECT_THROW(moved_rings(body, layer(equal_radii(5, 0.24)), 1.04), std::invalid_argument);
  auto coarse = layer(equal_radii(8, 0.15));
  coarse.half_space = std::make_shared<const Compliance>(half_space(equal_radii(7, 0.15)));
  EXPECT_THROW(moved_rings(body, coarse, 1.04), std::invalid_argument);
  EXPECT_THROW(moved_rings(body, half_space(equal_radii(8, 0.15)), 1.04), std::invalid_argument);
}

}  // namespace
}  // namespace fretval::fem
