#include "fem/stick_zone/edge_near_largest_contact.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::edge_near_largest_contact_test {
namespace {

constexpr double other = 1e-9;
constexpr int n_steps = 36, n_hidden = 5;

/// A cycle of a flat punch of unit depth whose edge, as it was read, runs along cubics to 1 and back. The kink is
/// hidden at n_hidden instants on either side.
NormalHistory history_of(const ContactProblem& problem) {
  const Eigen::Index n = 24;
  NormalHistory history;
  history.steps_per_cycle = n_steps;
  history.n_cycles = 1;
  history.time.resize(n_steps + 1);
  history.pressure = punch_traction(problem, n).replicate(1, n_steps + 1);
  history.force = history.contact_radius = Eigen::VectorXd::Zero(n_steps + 1);
  history.hidden_kink = Eigen::VectorX<bool>::Constant(n_steps + 1, false);
  history.force_uncertainty = Eigen::VectorXd::Constant(n_steps + 1, other);
  history.n_closed = Eigen::VectorX<Eigen::Index>::Constant(n_steps + 1, n);
  for (int k = 0; k <= n_steps; ++k) {
    const double t = history.time[k] = 2 * pi * k / n_steps, to_end = t - 2 * pi;
    history.contact_radius[k] = k <= n_steps / 2 ? 1 - 0.03 * t + 0.004 * t * t * t : 1 - 0.05 * to_end * to_end;
    history.hidden_kink[k] = (k > 0 && k <= n_hidden) || (k < n_steps && k >= n_steps - n_hidden);
  }
  return history;
}

TEST(EdgeNearLargestContact, IsReadFromTheEdgeOverTime) {
  const auto& problem = normal_half_space(32);
  auto history = history_of(problem);
  const auto right = history.contact_radius;
  constexpr double off = 0.02;
  for (const int k : {3, n_steps - 2}) {
    history.contact_radius[k] += off;
    history.force[k] = off * problem.series.force_per_radius();
  }
  read_edges_near_largest_contact(problem.series, 1, history);
  for (int k = 0; k <= n_steps; ++k) {
    EXPECT_NEAR(history.contact_radius[k], right[k], 1e-12) << k;
    EXPECT_NEAR(history.force[k], 0, 1e-10) << k;
    EXPECT_EQ(history.force_uncertainty[k], other) << k;
  }
}

TEST(EdgeNearLargestContact, MayBeAnywhereBeyondTheLastClosedRingWhereTooFewInstantsSeeIt) {
  const auto& problem = normal_half_space(32);
  auto history = history_of(problem);
  history.hidden_kink[n_hidden + 3] = true;
  history.n_closed[n_steps - n_hidden - 1] = 0;
  const Eigen::VectorXd force = history.force, radius = history.contact_radius;
  read_edges_near_largest_contact(problem.series, 1, history);
  EXPECT_EQ(history.force, force);
  EXPECT_EQ(history.contact_radius, radius);
  const double closed = problem.series.radii()[history.n_closed[3] - 1];
  for (const int k : {3, n_steps - 2})
    EXPECT_NEAR(history.force_uncertainty[k], std::abs(radius[k] - closed) * problem.series.force_per_radius() + other,
                1e-10)
        << k;
}

}  // namespace
}  // namespace fretval::fem::edge_near_largest_contact_test
