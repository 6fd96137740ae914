#include "fem/condensation/effective_radii.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "fem/condensation/contact_events.h"
#include "fem/stick_zone/contact_radius.h"
#include "fem/stick_zone/edge_radius.h"
#include "fem/stick_zone/stick_radius.h"
#include "fem/stick_zone/touch_indentation.h"
#include "fem/support/constants.h"
#include "tests/fem/convergence.h"
#include "tests/fem/expect_solver_error.h"
#include "tests/fem/half_space.h"
#include "tests/fem/recorded_history.h"

namespace fretval::fem::effective_radii_test {
namespace {

using Eigen::Index;

double parabola(double r) {
  return r * r / 2;
}

// beta belongs to the discretisation of the edge alone, so it is the same on every mesh and for every radius: 0.099 to
// 0.114 measured, in either harmonic.
TEST(EffectiveRadii, AreShortOfTheRingsByAConstantFractionOfARing) {
  for (const Harmonic harmonic : {Harmonic::normal, Harmonic::tangential})
    for (const unsigned n : {16U, 64U, 128U}) {
      const auto& compliance = half_space(harmonic, n).compliance;
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

// The definition: force of the punch over a force per radius, which is 8 G d for a half-space (THEORY section 8); 1e-3
// off at 32 rings, h^2.
TEST(EffectiveRadii, AreProportionalToThePunchForce) {
  const auto& compliance = normal_half_space(32).compliance;
  const Eigen::VectorXd radii = effective_radii(compliance).radius;
  std::vector<double> per_radius;
  for (const Index m : {1, 9, 20, 36}) {
    const Eigen::VectorXd areas = compliance.areas.head(m);
    per_radius.push_back(areas.dot(compliance.matrix.topLeftCorner(m, m).llt().solve(areas)) / radii[m]);
  }
  for (const double value : per_radius) EXPECT_NEAR(value, per_radius[0], 1e-10);
  EXPECT_NEAR(per_radius[0], 8, 2e-3);
}

class ContactEventsTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(64);
  Eigen::VectorXd profile_ = ring_means(problem_.compliance, parabola);
  ContactEvents events_ = contact_events(problem_.compliance, profile_);
};

// Second method: the contact solver, just before and after.
TEST_F(ContactEventsTest, AreWhereTheContactGainsARing) {
  for (const Index m : {0, 1, 7, 40, 63}) {
    const double d = events_.indentation[m], step = 1e-6 * d;
    const auto before = static_contact(problem_, profile_, d - step),
               after = static_contact(problem_, profile_, d + step);
    EXPECT_EQ(before.pressure[m], 0);
    EXPECT_GT(before.gap[m], 0);
    EXPECT_GT(after.pressure[m], 0);
    EXPECT_EQ(after.pressure[m + 1], 0);
    // Roundoff of the gap over the step: 1e-16 / 1e-6.
    EXPECT_NEAR(before.gap[m] / step, events_.closing_rate[m], 1e-5);
  }
}

TEST_F(ContactEventsTest, FirstTouchIsTheProfileItself) {
  EXPECT_EQ(events_.indentation[0], profile_[0]);
  EXPECT_EQ(events_.closing_rate[0], 1);
  EXPECT_EQ(events_.radius[0], 0);
}

// Oracle: a = sqrt(R d). Root mean square over the events, as a poor cell below a ring spoils its one event (1.8e-5 at
// one of 128, where the others are at 5e-6 at most).
TEST(ContactEvents, RadiiAreThoseOfHertz) {
  std::vector<double> errors;
  for (const unsigned n : {16U, 32U, 64U, 128U}) {
    const auto& compliance = normal_half_space(n).compliance;
    const auto events = contact_events(compliance, ring_means(compliance, parabola));
    double square = 0;
    for (Index m = n / 4; m < n; ++m)
      square += std::pow(events.radius[m] - std::sqrt(events.indentation[m]), 2) / (0.75 * n);
    errors.push_back(std::sqrt(square));
  }
  EXPECT_GT(observed_order(errors), 1.5);
  EXPECT_LT(errors[2], 1e-4);
}

// All rings of a flat face touch at once, so there is nothing to extrapolate from.
TEST(ContactEvents, RadiiUnderAFlatFaceStayWhereTheirRingsAre) {
  const auto& problem = normal_half_space(32);
  const double flat = 0.6, ring = 1.0 / 32;
  const auto profile =
      ring_means(problem.compliance, [=](double r) { return r > flat ? (r - flat) * (r - flat) / 2 : 0; });
  const auto events = contact_events(problem.compliance, profile);
  for (Eigen::Index m = 1; m < events.radius.size(); ++m)
    EXPECT_NEAR(events.radius[m], problem.compliance.radii[static_cast<std::size_t>(m)], ring) << m;
}

TEST_F(ContactEventsTest, TouchIndentationOfOneRingIsItsEvent) {
  for (const Index m : {1, 7, 40, 63})
    EXPECT_NEAR(touch_indentation(problem_.compliance, profile_, m, 1), events_.indentation[m], 1e-12);
}

// Second method: the box solver with the rings inside glued to the indenter and the others free, and bisection on the
// mean gap of the flank.
TEST_F(ContactEventsTest, TouchIndentationOfAFlankClosesItsMeanGap) {
  const Index n_pressed = 40, n_flank = 6, n = problem_.n_rings();
  const auto& areas = problem_.compliance.areas;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Eigen::VectorXd lower = Eigen::VectorXd::Zero(n), upper = lower;
  lower.head(n_pressed).setConstant(-infinity);
  upper.head(n_pressed).setConstant(infinity);
  const auto mean_gap = [&](double d) {
    std::vector<BoxState> states(static_cast<std::size_t>(n), BoxState::interior);
    const auto glued = problem_.solver.solve(areas.cwiseProduct((d - profile_.array()).matrix()), lower, upper, states);
    return -glued.residual.segment(n_pressed, n_flank).sum();
  };
  double below = 0, above = 1;
  for (int k = 0; k < 60; ++k) (mean_gap((below + above) / 2) > 0 ? below : above) = (below + above) / 2;
  EXPECT_GT(below, events_.indentation[n_pressed]);
  EXPECT_NEAR(touch_indentation(problem_.compliance, profile_, n_pressed, n_flank), below, 1e-12);
}

TEST_F(ContactEventsTest, LargestContactRadiusNeedsAnEdge) {
  const Eigen::VectorXd closed = Eigen::VectorXd::Zero(problem_.n_rings()), open = closed.array() + 1;
  expect_solver_error([&] { largest_contact_radius(closed, events_); }, {"no edge inside the contact line"});
  expect_solver_error([&] { largest_contact_radius(open, events_); }, {"no edge inside the contact line"});
}

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

// A reserve that does not fall towards the edge at all, as inside the flat of a punch with sharp edges.
TEST_F(StickRadiusTest, StaysWithinARingOfTheLastOneThatSticks) {
  const Eigen::VectorXd reserve = Eigen::VectorXd::LinSpaced(compliance_.areas.size(), 1.01, 1);
  const auto edge = stick_radius(compliance_, reserve, 30);
  EXPECT_NEAR(edge.radius, 30.0 / 64, 1.0 / 64);
  EXPECT_EQ(edge.uncertainty, 1.0 / 64);
}

TEST_F(StickRadiusTest, OfOneOrTwoRingsIsUncertainByARing) {
  const Eigen::VectorXd reserve = Eigen::VectorXd::Ones(compliance_.areas.size());
  EXPECT_EQ(stick_radius(compliance_, reserve, 0).radius, 0);
  EXPECT_EQ(stick_radius(compliance_, reserve, 2).radius, effective_radii(compliance_).radius[2]);
  for (const Index n : {0, 1, 2}) EXPECT_DOUBLE_EQ(stick_radius(compliance_, reserve, n).uncertainty, 1.0 / 64);
}

}  // namespace
}  // namespace fretval::fem::effective_radii_test
