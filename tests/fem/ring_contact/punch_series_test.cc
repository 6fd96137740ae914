#include "fem/ring_contact/punch_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fem/ring_contact/effective_radii.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::punch_series_test {
namespace {

using Eigen::Index;

std::vector<signed char> one_zone(const Eigen::VectorXd& field) {
  return std::vector<signed char>(static_cast<std::size_t>(field.size()), 0);
}

class PunchSeriesTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(32);
  const PunchSeries& series_ = problem_.series;
};

TEST_F(PunchSeriesTest, DepthsAndDisplacementsAreConjugate) {
  const Index n = problem_.n_rings();
  const Eigen::VectorXd traction = Eigen::VectorXd::LinSpaced(n, 1, -0.3).array().cos();
  const Eigen::VectorXd displacement = Eigen::VectorXd::LinSpaced(n, 0.2, 2).array().sin();
  const Eigen::VectorXd b =
      problem_.solver.factor()->triangularView<Eigen::Lower>().solve(problem_.compliance.areas).array().square();
  const double work = problem_.compliance.areas.dot(traction.cwiseProduct(displacement));
  const Eigen::VectorXd depths = series_.depths(traction);
  EXPECT_NEAR(b.dot(depths.cwiseProduct(series_.displacements(displacement))), work, 1e-12 * std::abs(work));
  EXPECT_NEAR(b.dot(depths), traction.dot(problem_.compliance.areas), 1e-12);
}

TEST_F(PunchSeriesTest, RingsFollowFromTheirDisplacements) {
  const Index n = problem_.n_rings(), first = 20, n_moved = 7;
  Eigen::VectorXd displacements = Eigen::VectorXd::Zero(n);
  displacements.segment(first, n_moved).setLinSpaced(0.3, 1);
  Eigen::VectorXd rings = Eigen::VectorXd::Zero(n);
  rings.segment(first, n_moved) = displacements.segment(first, n_moved);
  series_.to_rings(rings.segment(first, n_moved), first);
  EXPECT_LT((series_.displacements(rings) - displacements).head(first + n_moved).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(PunchSeriesTest, AFlatPunchIsEquallyDeepEverywhere) {
  const Index n = 20;
  const Eigen::VectorXd depths = series_.depths(punch_traction(problem_, n));
  EXPECT_LT((depths.head(n).array() - 1).abs().maxCoeff(), 1e-11);
  EXPECT_EQ(depths.tail(depths.size() - n).cwiseAbs().maxCoeff(), 0);
}

// Two parabolas that meet at a kink half way between two depths: the integral follows both.
TEST_F(PunchSeriesTest, FollowsBothSidesOfAKink) {
  const Eigen::VectorXd edges = effective_radii(problem_.compliance).radius;
  const Index n = problem_.n_rings();
  const double kink = edges[16] + 0.5 / 32, a = edges[n];
  Eigen::VectorXd depths(n);
  std::vector<signed char> zones(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) {
    const double r = (edges[i] + edges[i + 1]) / 2;
    depths[i] = 1 - r * r / 4 - (r > kink ? 0.5 * (r - kink) : 0);
    zones[static_cast<std::size_t>(i)] = i > 16 ? 1 : 0;
  }
  const double exact = 8 * (a - a * a * a / 12 - 0.25 * (a - kink) * (a - kink));
  const double with = series_.integral(depths, zones).value, without = series_.integral(depths, one_zone(depths)).value;
  EXPECT_NEAR(with / exact, 1, 2e-6);  // the force per radius, see EffectiveRadii
  EXPECT_GT(std::abs(without - with) / exact, 1e-5);
}

// A zone of a single ring hides where its kinks are. Wherever in their rings, the sum is off by less than it says, and
// where both sides are known nothing is left open.
TEST_F(PunchSeriesTest, SaysWhatKinksInSingleRingsLeaveOpen) {
  const auto& edges = series_.edges();
  const Index n = problem_.n_rings();
  double largest_share = 0;
  for (int place = 0; place < 20; ++place) {
    const double kink = edges[16] + place / 19.0 * (edges[17] - edges[16]), a = edges[n];
    Eigen::VectorXd depths(n);
    std::vector<signed char> zones(static_cast<std::size_t>(n), 1);
    for (Index i = 0; i < n; ++i) depths[i] = std::max(kink - series_.radii()[i], 0.0);
    zones[16] = 2;
    std::fill(zones.begin(), zones.begin() + 16, 0);
    const double exact = series_.force_per_radius() * kink * kink / 2,
                 error = std::abs(series_.integral(depths, zones, a).value - exact),
                 left_open = series_.integral(depths, zones).unseen_kinks;
    EXPECT_LT(error, left_open + 1e-6 * exact) << place;
    largest_share = std::max(largest_share, error / left_open);
    zones[16] = kink > series_.radii()[16] ? 0 : 1;
    EXPECT_EQ(series_.integral(depths, zones).unseen_kinks, 0);
  }
  EXPECT_GT(largest_share, 0.4);
}

TEST_F(PunchSeriesTest, ShortZonesFallBackToTheSum) {
  const Eigen::VectorXd pressure = Eigen::VectorXd::Ones(problem_.n_rings());
  std::vector<signed char> zones(static_cast<std::size_t>(problem_.n_rings()));
  for (std::size_t i = 0; i < zones.size(); ++i) zones[i] = static_cast<signed char>(i % 2);
  EXPECT_NEAR(series_.integral(series_.depths(pressure), zones).value, problem_.compliance.areas.sum(),
              2e-3 * problem_.compliance.areas.sum());
}

}  // namespace
}  // namespace fretval::fem::punch_series_test
