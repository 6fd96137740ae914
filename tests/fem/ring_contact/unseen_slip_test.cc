#include "fem/ring_contact/unseen_slip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/half_space.h"

namespace fretval::fem::unseen_slip_test {
namespace {

/// Depths of a limit that falls linearly from the centre to an edge between two rings.
Eigen::VectorXd falling_to(double edge, const Eigen::VectorXd& radii) {
  return (edge - radii.array()).max(0);
}

// Springs under a cone that is moved to and fro by u: those within u of the edge slip by 4 (u - l) against l.
TEST(UnseenSlip, IsThatOfSpringsBetweenTheLastRingThatSticksAndTheEdge) {
  const auto& series = tangential_half_space(16).series;
  const Eigen::VectorXd& radii = series.radii();
  const Eigen::Index last = 9;
  const double width = radii[last + 1] - radii[last], edge = radii[last] + 0.8 * width;
  const Eigen::VectorXd limits = falling_to(edge, radii);
  const auto depths_of = [&](double u) -> Eigen::VectorXd { return limits.array().min(u); };
  for (const double share : {0.5, 1.0}) {  // the last ring sticks, or slips
    const double u = share * width;
    // 4 int_0^u l (u - l) dl, times the force per depth and length
    const double exact = 4 * std::pow(u, 3) / 6 * series.force_per_radius();
    EXPECT_NEAR(unseen_slip_energy(series, depths_of(u), limits) / exact, 1, 0.03) << share;
  }
  EXPECT_EQ(unseen_slip_energy(series, depths_of(2 * width), limits), 0) << "two rings slip";
}

TEST(UnseenSlip, IsTheLargestOfTheSteps) {
  const auto& series = tangential_half_space(16).series;
  const Eigen::VectorXd wide = falling_to(series.radii()[9] + 0.01, series.radii()),
                        narrow = falling_to(series.radii()[8] + 0.01, series.radii());
  const Eigen::VectorXd depths = 0.02 * (wide.array() > 0).cast<double>();
  const double alone = unseen_slip_energy(series, depths, wide);
  ASSERT_GT(alone, 0);
  EXPECT_EQ(unseen_slip_energy(series, -depths, wide), alone);
  Eigen::MatrixXd limits(wide.size(), 2), both(wide.size(), 2);
  limits << wide, narrow;
  both << depths, 0 * depths;
  EXPECT_EQ(unseen_slip_energy(series, both, limits), alone) << "the outermost ring lifts for a while";
  both.col(1) = narrow;
  EXPECT_EQ(unseen_slip_energy(series, both, limits), 0) << "all of them slip for a while";
}

// In phase, tractions are in proportion to pressures.
TEST(UnseenSlip, IsNoneWhereTheTractionEndsWithThePressure) {
  const auto& series = tangential_half_space(16).series;
  const Eigen::VectorXd limits = falling_to(0.63, series.radii());
  EXPECT_EQ(unseen_slip_energy(series, 0.8 * limits, limits), 0);
  EXPECT_EQ(unseen_slip_energy(series, 0 * limits, 0 * limits), 0) << "no contact";
}

}  // namespace
}  // namespace fretval::fem::unseen_slip_test
