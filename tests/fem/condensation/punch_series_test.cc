#include "fem/condensation/punch_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fem/condensation/contact_events.h"
#include "fem/condensation/effective_radii.h"
#include "fem/history/contact_force.h"
#include "fem/history/friction_force.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::punch_series_test {
namespace {

using Eigen::Index;

StaticContact hertz_contact(const ContactProblem& problem, double indentation) {
  const auto profile = ring_means(problem.compliance, [](double r) { return r * r / 2; });
  return static_contact(problem, profile, indentation);
}

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
      problem_.solver.factor().triangularView<Eigen::Lower>().solve(problem_.compliance.areas).array().square();
  const double work = problem_.compliance.areas.dot(traction.cwiseProduct(displacement));
  const Eigen::VectorXd depths = series_.depths(traction);
  EXPECT_NEAR(b.dot(depths.cwiseProduct(series_.displacements(displacement))), work, 1e-12 * std::abs(work));
  EXPECT_NEAR(b.dot(depths), traction.dot(problem_.compliance.areas), 1e-12);
}

TEST_F(PunchSeriesTest, AFlatPunchIsEquallyDeepEverywhere) {
  const Index n = 20;
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(problem_.n_rings());
  pressure.head(n) = problem_.compliance.matrix.topLeftCorner(n, n).llt().solve(problem_.compliance.areas.head(n));
  const Eigen::VectorXd depths = series_.depths(pressure);
  EXPECT_LT((depths.head(n).array() - 1).abs().maxCoeff(), 1e-11);
  EXPECT_EQ(depths.tail(depths.size() - n).cwiseAbs().maxCoeff(), 0);
}

// Hertz: F = (16/3) G sqrt(R) d^1.5, R = 1, at eleven positions of the edge within its ring. The plain sum is of second
// order (3e-4), the integral of third (7e-7); without the zone of the free rings it would not find the edge.
TEST_F(PunchSeriesTest, ForceIsAccurateWhereverTheEdgeIs) {
  double worst = 0, worst_sum = 0, worst_without_zones = 0;
  for (int k = 0; k <= 10; ++k) {
    const double radius = 0.9 + k / 320.0, exact = 16.0 / 3 * radius * radius * radius;
    const auto [pressure, gap] = hertz_contact(problem_, radius * radius);
    const double force = contact_force(series_, pressure, gap).force;
    worst = std::max(worst, std::abs(force / exact - 1));
    worst_sum = std::max(worst_sum, std::abs(pressure.dot(problem_.compliance.areas) / exact - 1));
    const double unaware = series_.integral(series_.depths(pressure), one_zone(pressure));
    worst_without_zones = std::max(worst_without_zones, std::abs(unaware / exact - 1));
  }
  EXPECT_LT(worst, 2e-6);
  EXPECT_GT(worst_sum, 1e-4);
  EXPECT_GT(worst_without_zones, 1e-5);
}

// Pressure and gap vanish at the same radius.
TEST_F(PunchSeriesTest, FindsTheEdgeFromTheGapAlone) {
  for (int k = 0; k <= 10; ++k) {
    const double radius = 0.9 + k / 320.0;
    const auto [pressure, gap] = hertz_contact(problem_, radius * radius);
    const Index n_pressed = (pressure.array() > 0).count();
    EXPECT_NEAR(series_.edge_of_gap(gap, n_pressed, n_pressed, 0).value(), radius, 1e-5) << radius;
  }
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
  const double with = series_.integral(depths, zones), without = series_.integral(depths, one_zone(depths));
  EXPECT_NEAR(with / exact, 1, 2e-6);  // the force per radius, see EffectiveRadii
  EXPECT_GT(std::abs(without - with) / exact, 1e-5);
}

// Mindlin & Deresiewicz: F = F(u0) - 2 F((u0 - u)/2) on the way back from u0, F(u) = mu P [1 - (1 - u/u_all)^1.5]. Just
// after the reversal hardly a ring slips back, and just before -u0 hardly one of those that slipped before u0 is left.
TEST_F(PunchSeriesTest, FrictionForceOfZonesNarrowerThanARing) {
  const auto& tangential = tangential_half_space(32);
  const double mu = 0.5, all_slides = 1.5 * mu, u0 = 0.5 * all_slides;
  const auto contact = hertz_contact(problem_, 1);
  const Eigen::VectorXd limit = mu * contact.pressure;
  const auto normal = contact_force(series_, contact.pressure, contact.gap);
  const double normal_force = normal.force;
  EXPECT_LT(normal.uncertainty, 1e-6 * normal_force);
  TouchingRings touching{series_.radii()};
  touching.move_to(normal.radius);
  const auto exact = [&, f = normal_force](double u) { return mu * f * (1 - std::pow(1 - u / all_slides, 1.5)); };
  Eigen::VectorXd slip = Eigen::VectorXd::Zero(problem_.n_rings());
  std::vector<BoxState> states(static_cast<std::size_t>(slip.size()), BoxState::interior);
  SlipZones zones(slip.size());
  double worst = 0, worst_sum = 0;
  for (int k = 0; k <= 100; ++k) {
    const double u = u0 * (1 - k / 50.0);
    const auto& areas = tangential.compliance.areas;
    const Eigen::VectorXd load = areas.array() * (u - slip.array());
    const auto solution = tangential.solver.solve(load, -limit, limit, states);
    slip += solution.residual.cwiseQuotient(areas);
    zones.update(limit, states, tangential.series.depths(solution.x));
    const double force =
        friction_force(tangential.series, zones, touching, tangential.series.depths(limit), mu * normal_force);
    const double expected = exact(u0) - 2 * exact((u0 - u) / 2);
    worst = std::max(worst, std::abs(force - expected) / exact(u0));
    worst_sum = std::max(worst_sum, std::abs(solution.x.dot(areas) - expected) / exact(u0));
  }
  EXPECT_LT(worst, 4e-5);
  EXPECT_GT(worst_sum, 5e-4);
}

// A contact that grows while it sticks, from rest: each spring carries on from where it touched, so the force is that
// of the normal one, 2/3 of the slope as large (Jaeger 1993).
TEST_F(PunchSeriesTest, FrictionForceOfAContactThatGrows) {
  const auto& tangential = tangential_half_space(32);
  const double mu = 0.5, slope = 0.3, first = 0.5, last = 0.62;
  Eigen::VectorXd slip = Eigen::VectorXd::Zero(problem_.n_rings());
  std::vector<BoxState> states(static_cast<std::size_t>(slip.size()), BoxState::interior);
  SlipZones zones(slip.size());
  TouchingRings touching{series_.radii()};
  double first_force = 0, worst = 0, worst_sum = 0;
  // Steps end where a ring touches: a ring that touches within one would stick since its beginning.
  std::vector<double> indentations;
  for (int k = 0; k <= 40; ++k) indentations.push_back(first + 0.003 * k);
  const Eigen::VectorXd profile = ring_means(problem_.compliance, [](double r) { return r * r / 2; });
  for (const double d : contact_events(problem_.compliance, profile).indentation)
    if (first < d && d < last) indentations.push_back(d);
  std::sort(indentations.begin(), indentations.end());
  for (const double indentation : indentations) {
    const auto contact = hertz_contact(problem_, indentation);
    const auto normal = contact_force(series_, contact.pressure, contact.gap);
    if (indentation == first) first_force = normal.force;
    touching.move_to(normal.radius);
    const Eigen::VectorXd limit = mu * contact.pressure;
    const auto& areas = tangential.compliance.areas;
    const Eigen::VectorXd load = areas.array() * (slope * (indentation - first) - slip.array());
    const auto solution = tangential.solver.solve(load, -limit, limit, states);
    slip += solution.residual.cwiseQuotient(areas);
    zones.update(limit, states, tangential.series.depths(solution.x));
    const double force =
        friction_force(tangential.series, zones, touching, tangential.series.depths(limit), mu * normal.force);
    const double exact = 2.0 / 3 * slope * (normal.force - first_force);
    worst = std::max(worst, std::abs(force - exact));
    worst_sum = std::max(worst_sum, std::abs(solution.x.dot(areas) - exact));
  }
  EXPECT_LT(worst, 6e-6 * first_force);
  EXPECT_GT(worst_sum, 1e-4 * first_force);
}

TEST_F(PunchSeriesTest, ShortZonesFallBackToTheSum) {
  const Eigen::VectorXd pressure = Eigen::VectorXd::Ones(problem_.n_rings());
  std::vector<signed char> zones(static_cast<std::size_t>(problem_.n_rings()));
  for (std::size_t i = 0; i < zones.size(); ++i) zones[i] = static_cast<signed char>(i % 2);
  EXPECT_NEAR(series_.integral(series_.depths(pressure), zones), problem_.compliance.areas.sum(),
              2e-3 * problem_.compliance.areas.sum());
}

}  // namespace
}  // namespace fretval::fem::punch_series_test
