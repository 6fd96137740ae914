#include "fem/ring_contact/stick_zone/stick_radius.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

#include "fem/ring_contact/effective_radii.h"
#include "fem/support/constants.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::stick_radius_test {
namespace {

using Eigen::Index;

class StickRadiusTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = tangential_half_space(64);
  const Compliance& compliance_ = problem_.compliance;

  /// The margin under a profile f(r) "pressed" by d: positive inside the radius at which the transform g of f is d.
  EdgeRadius radius_of(const std::function<double(double)>& f, double d) const {
    const auto margin = static_contact(problem_, ring_means(compliance_, f), d).pressure;
    Index n_stuck = 0;
    while (n_stuck < margin.size() && margin[n_stuck] > 0) ++n_stuck;
    return stick_radius(compliance_, problem_.series.depths(margin), n_stuck);
  }
};

// Margins like sqrt(c^2 - r^2) (parabola, g = 2 f) and like arcosh(c/r) (cone, g = pi/2 f); 1e-5 to 3e-5 measured at 64
// rings.
TEST_F(StickRadiusTest, IsTheRadiusAtWhichTheTransformReachesTheDepth) {
  for (const double c : {0.15, 0.3, 0.5, 0.7, 0.9}) {
    EXPECT_NEAR(radius_of([](double r) { return r * r; }, 2 * c * c).radius, c, 5e-5) << c;
    EXPECT_NEAR(radius_of([](double r) { return r; }, pi / 2 * c).radius, c, 1e-4) << c;
  }
}

// A reserve whose curvature changes, whichever way, is read in two ways that differ.
TEST_F(StickRadiusTest, IsLessCertainWhereTheReserveIsNoParabola) {
  const Eigen::VectorXd edges = effective_radii(compliance_).radius;
  const Index n = compliance_.areas.size();
  const auto uncertainty = [&](double cubic) {
    const Eigen::ArrayXd x = (edges.head(n) + edges.tail(n)).array() / 2 - edges[30];
    return stick_radius(compliance_, (cubic * x.cube() - x).matrix(), 30).uncertainty;
  };
  for (const double cubic : {-30.0, 30.0}) EXPECT_GT(uncertainty(cubic), 1.01 * uncertainty(0)) << cubic;
}

// Over the base of a layer reserves are no parabolas: four rings tell the cubic.
TEST_F(StickRadiusTest, FollowsACubicOverALayer) {
  const auto edges = effective_radii(compliance_);
  auto layer = compliance_;
  layer.half_space = std::make_shared<const Compliance>(compliance_);
  for (const double share : {0.1, 0.5, 0.9}) {
    const double c = edges.of_rings[29] + share * (edges.of_rings[30] - edges.of_rings[29]);
    const Eigen::ArrayXd x = edges.of_rings.array() - c;
    const Eigen::VectorXd reserve = 30 * x.cube() - x;
    EXPECT_NEAR(stick_radius(layer, edges, reserve, 30).radius, c, 1e-11) << share;
    EXPECT_GT(std::abs(stick_radius(compliance_, edges, reserve, 30).radius - c), 1e-6) << share;
  }
}

// A reserve that does not fall towards the edge at all, as inside the flat of a punch with sharp edges.
TEST_F(StickRadiusTest, StaysWithinARingOfTheLastOneThatSticks) {
  const Eigen::VectorXd reserve = Eigen::VectorXd::LinSpaced(compliance_.areas.size(), 1.01, 1);
  const auto edge = stick_radius(compliance_, reserve, 30);
  EXPECT_NEAR(edge.radius, 30.0 / 64, 1.0 / 64);
  EXPECT_EQ(edge.uncertainty, 1.0 / 64);
}

// The edge of a flat lies among the last six rings, and lifts the reserve of its ring: no cubic follows that.
TEST_F(StickRadiusTest, IsReadBeyondAKinkOfTheReserve) {
  const Eigen::VectorXd at = effective_radii(compliance_).of_rings;
  for (const double share : {0.1, 0.4, 0.7, 0.9}) {
    const double c = at[29] + share * (at[30] - at[29]);
    Eigen::VectorXd reserve = (c - at.array()).max(0);
    reserve[25] += 1.0 / 64;
    const auto [radius, uncertainty] = stick_radius(compliance_, reserve, 30);
    EXPECT_NEAR(radius, c, 1e-3 / 64) << share;
    EXPECT_LT(uncertainty, 0.5 / 64) << share;
  }
}

// Under a blunt tip, g = 8/3 r^4, three rings are off by up to a third of one, which a second reading has to tell.
TEST_F(StickRadiusTest, OfThreeRingsIsWithinItsUncertainty) {
  for (const double rings : {2.7, 3.0, 3.3}) {
    const double c = rings / 64;
    const auto [radius, uncertainty] = radius_of([](double r) { return std::pow(r, 4); }, 8.0 / 3 * std::pow(c, 4));
    EXPECT_LT(std::abs(radius - c), uncertainty) << rings;
    EXPECT_LT(uncertainty, 1.5 / 64) << rings;
  }
}

TEST_F(StickRadiusTest, OfOneOrTwoRingsIsUncertainByARing) {
  const Eigen::VectorXd reserve = Eigen::VectorXd::Ones(compliance_.areas.size());
  EXPECT_EQ(stick_radius(compliance_, reserve, 0).radius, 0);
  EXPECT_EQ(stick_radius(compliance_, reserve, 2).radius, effective_radii(compliance_).radius[2]);
  for (const Index n : {0, 1, 2}) EXPECT_DOUBLE_EQ(stick_radius(compliance_, reserve, n).uncertainty, 1.0 / 64);
}

}  // namespace
}  // namespace fretval::fem::stick_radius_test
