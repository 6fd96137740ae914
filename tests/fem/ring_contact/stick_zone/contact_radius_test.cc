#include "fem/ring_contact/stick_zone/contact_radius.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/expect_solver_error.h"

namespace fretval::fem::contact_radius_test {
namespace {

constexpr Eigen::Index n_events = 20;

/// Of degree 5: what six events determine.
const auto radius_of = [](double d) { return d * (2 - d) + 0.1 * std::pow(d, 5); };

ContactEvents events() {
  ContactEvents events{Eigen::VectorXd::LinSpaced(n_events, 0, 0.95), Eigen::VectorXd::LinSpaced(n_events, 1, 0.3), {}};
  events.radius = events.indentation.unaryExpr(radius_of);
  return events;
}

/// All rings that touch at d are closed, the others have what is left to go at their closing rates.
Eigen::VectorXd gaps_at(double d) {
  return ((events().indentation.array() - d) * events().closing_rate.array()).max(0);
}

// Next to the first events, in the middle and next to the last one. Roundoff of the divided differences.
TEST(LargestContactRadius, IsThatOfThePolynomialThroughSixEvents) {
  for (const double d : {0.06, 0.16, 0.52, 0.5, 0.91, 0.949})
    EXPECT_NEAR(largest_contact_radius(gaps_at(d), events()).radius, radius_of(d), 1e-12) << d;
}

// Between the events of indentation 0.5 and 0.55.
TEST(LargestContactRadius, IsUncertainByTheDistanceOfItsEvents) {
  EXPECT_NEAR(largest_contact_radius(gaps_at(0.52), events()).uncertainty, radius_of(0.55) - radius_of(0.5), 1e-14);
}

TEST(LargestContactRadius, NeedsAnEdge) {
  const Eigen::VectorXd closed = Eigen::VectorXd::Zero(n_events), open = closed.array() + 1;
  expect_solver_error([&] { largest_contact_radius(closed, events()); }, {"no edge inside the contact line"});
  expect_solver_error([&] { largest_contact_radius(open, events()); },
                      {"fewer than two rings touch", "creeps for long"});
}

}  // namespace
}  // namespace fretval::fem::contact_radius_test
