#include "fem/ring_contact/stick_zone/touch_indentation.h"

#include <gtest/gtest.h>

#include <vector>

#include "fem/ring_contact/contact_events.h"
#include "fem/support/constants.h"
#include "tests/fem/fretting.h"
#include "tests/fem/half_space.h"

namespace fretval::fem::touch_indentation_test {
namespace {

using Eigen::Index;

class TouchIndentationTest : public testing::Test {
 protected:
  const ContactProblem& problem_ = normal_half_space(64);
  const Eigen::VectorXd profile_ = parabola_means(problem_);
  const Eigen::VectorXd events_ = contact_events(problem_.compliance, profile_).indentation;
};

// Roundoff.
TEST_F(TouchIndentationTest, OfOneRingIsItsEvent) {
  for (const Index m : {1, 7, 40, 63})
    EXPECT_NEAR(touch_indentation(problem_.compliance, profile_, m, 1), events_[m], 1e-12);
}

// Second method: the box solver with the rings inside glued to the indenter and the others free, and bisection on the
// mean gap of the flank.
TEST_F(TouchIndentationTest, OfAFlankClosesItsMeanGap) {
  const Index n_pressed = 40, n_flank = 6, n = problem_.n_rings();
  const auto& areas = problem_.compliance.areas;
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
  EXPECT_GT(below, events_[n_pressed]);
  EXPECT_NEAR(touch_indentation(problem_.compliance, profile_, n_pressed, n_flank), below, 1e-12);
}

}  // namespace
}  // namespace fretval::fem::touch_indentation_test
