#include "fem/ring_contact/unseen_slip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/fem/half_space.h"

namespace fretval::fem::unseen_slip_test {
namespace {

/// Depths of a limit that falls linearly from the centre to an edge between two rings.
Eigen::VectorXd falling_to(double edge, const Eigen::VectorXd& radii) {
  return (edge - radii.array()).max(0);
}

// Springs under a cone that is moved to and fro by u: those within u of the edge slip by 4 (u - l) against l.
TEST(UnseenSlip, IsThatOfSpringsBetweenTheLastRingAndTheEdge) {
  const auto& series = tangential_half_space(16).series;
  const Eigen::VectorXd& radii = series.radii();
  const Eigen::Index last = 9;
  const double width = radii[last + 1] - radii[last], edge = radii[last] + 0.8 * width, u = 0.5 * width;
  const Eigen::VectorXd limits = falling_to(edge, radii);
  const Eigen::VectorXd depths = (limits.array() > 0).select(Eigen::VectorXd::Constant(limits.size(), u), 0.0);
  // 4 int_0^u l (u - l) dl, times the force per depth and length
  const double exact = 4 * std::pow(u, 3) / 6 * series.force_per_radius();
  EXPECT_NEAR(unseen_slip_energy(series, depths, limits) / exact, 1, 0.03);
  EXPECT_EQ(unseen_slip_energy(series, -depths, limits), unseen_slip_energy(series, depths, limits));
  Eigen::MatrixXd both_limits(limits.size(), 2), both(limits.size(), 2);
  both_limits << limits, limits;
  both << depths, depths / 2;
  EXPECT_EQ(unseen_slip_energy(series, both, both_limits), unseen_slip_energy(series, depths, limits));
  both(last, 1) = limits[last];
  EXPECT_EQ(unseen_slip_energy(series, both, both_limits), 0) << "a ring slips";
  both(last, 1) = both_limits(last, 1) = 0;
  EXPECT_EQ(unseen_slip_energy(series, both, both_limits), 0) << "a ring lifts";
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
