#include "fem/ring_contact/contact_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "fem/ring_contact/effective_radii.h"
#include "tests/fem/convergence.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"
#include "tests/fem/stiffened_half_space.h"

namespace fretval::fem::contact_events_test {
namespace {

using Eigen::Index;

class ContactEventsTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(64);
  Eigen::VectorXd profile_ = parabola_means(problem_);
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
  for (const unsigned n : {16U, 32U, 64U}) {
    const auto& problem = normal_half_space(n);
    const auto events = contact_events(problem.compliance, parabola_means(problem));
    double square = 0;
    for (Index m = n / 4; m < n; ++m)
      square += std::pow(events.radius[m] - std::sqrt(events.indentation[m]), 2) / (0.75 * n);
    errors.push_back(std::sqrt(square));
  }
  EXPECT_GT(observed_order(errors), 1.5);
  EXPECT_LT(errors[2], 1e-4);
}

// On another body the ring that touches has its middle elsewhere than between the edges of the two discs about it.
TEST(ContactEvents, RadiiOnAnotherBodyAreOfThirdOrder) {
  std::vector<double> errors;
  for (const unsigned n : {16U, 32U, 64U}) {
    const StiffenedHalfSpace body(n);
    const auto events = contact_events(body.compliance(), parabola_means(normal_half_space(n)));
    double worst = 0;
    for (Index m = n / 2; m < n; ++m) {
      const double step = 1e-4, slope = (body.indentation_of_parabola(events.radius[m] + step) -
                                         body.indentation_of_parabola(events.radius[m] - step)) /
                                        (2 * step);
      worst = std::max(worst, std::abs(body.indentation_of_parabola(events.radius[m]) - events.indentation[m]) / slope);
    }
    errors.push_back(worst);
  }
  EXPECT_GT(observed_order(errors), 2.5);
  EXPECT_LT(errors[2], 1e-6);
}

// What a half-space leaves open of the edges of another body's rings, and a seventh more of the wide ones.
TEST(ContactEvents, KnowWhatTheEdgesOfRingsLeaveOpen) {
  auto body = normal_half_space(64).compliance;
  const Eigen::VectorXd profile = parabola_means(normal_half_space(64));
  const auto own = contact_events(body, profile);
  EXPECT_EQ(own.calibration, 0);
  body.half_space = std::make_shared<const Compliance>(body);
  const auto events = contact_events(body, profile);
  EXPECT_GT(events.calibration, 8.0 / 7 * effective_radii(body).calibration);
  EXPECT_LT(events.calibration, 1e-3 / 64);
  const Index from = 16, n = own.radius.size() - from;
  EXPECT_LT((events.radius - own.radius).tail(n).cwiseAbs().maxCoeff(), events.calibration);
}

TEST(SeriesUnder, HasItsDepthsAtTheEventsOfAnotherBodyThanAHalfSpace) {
  const Eigen::VectorXd profile = parabola_means(normal_half_space(32));
  const ContactProblem problem(StiffenedHalfSpace(32).compliance());
  const auto series = series_under(problem, profile);
  const Eigen::VectorXd events = contact_events(problem.compliance, profile).radius;
  EXPECT_EQ(series.radii().tail(series.radii().size() - 1), events.tail(events.size() - 1));
  EXPECT_EQ(series.radii()[0], problem.series.radii()[0]);
  EXPECT_EQ(series_under(normal_half_space(32), profile).radii(), normal_half_space(32).series.radii());
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

}  // namespace
}  // namespace fretval::fem::contact_events_test
