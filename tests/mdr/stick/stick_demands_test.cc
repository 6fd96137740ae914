#include "mdr/stick/stick_demands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mdr/support/constants.h"

namespace fretval::mdr::stick_demands_test {
namespace {

constexpr double roundoff = 1e-15;

// +-T cos(t + phase) - N cos(t): in phase a pull forward comes while the contact is pressed, one backward while it is
// not.
TEST(StickDemands, InPhaseForwardIsTheDifferenceAndBackwardTheSum) {
  EXPECT_NEAR(locked_demands(0.3, 0.1, 0).forward, 0.2, roundoff);
  EXPECT_NEAR(locked_demands(0.3, 0.1, 0).backward, 0.4, roundoff);
  EXPECT_NEAR(locked_demands(0.1, 0.3, 0).forward, 0.2, roundoff);
  EXPECT_NEAR(locked_demands(0.3, 0.1, pi).forward, 0.4, roundoff);
  EXPECT_NEAR(locked_demands(0.3, 0.1, pi).backward, 0.2, roundoff);
}

TEST(StickDemands, InQuadratureBothAreTheHypotenuse) {
  for (const double phase : {pi / 2, -pi / 2}) {
    EXPECT_NEAR(locked_demands(0.3, 0.4, phase).forward, 0.5, roundoff);
    EXPECT_NEAR(locked_demands(0.3, 0.4, phase).backward, 0.5, roundoff);
  }
}

// The sup over t as it is defined, by samples whose error is of order (2 pi/n)^2/8.
TEST(StickDemands, AreTheLargestExcessOverACycle) {
  const int n = 2000;
  for (const double phase : {0.4, 1.3, 2.9, -0.8}) {
    double forward = -1, backward = -1;
    for (int k = 0; k < n; ++k) {
      const double t = 2 * pi * k / n, pull = 0.3 * std::cos(t + phase), normal = 0.2 * std::cos(t);
      forward = std::max(forward, pull - normal);
      backward = std::max(backward, -pull - normal);
    }
    EXPECT_NEAR(locked_demands(0.3, 0.2, phase).forward, forward, 1e-6);
    EXPECT_NEAR(locked_demands(0.3, 0.2, phase).backward, backward, 1e-6);
  }
}

// |T e^(i phase) - T| = 2 T |sin(phase/2)|, where squares of the difference would lose all digits.
TEST(StickDemands, EqualAmplitudesNearlyInPhaseKeepTheirDigits) {
  EXPECT_NEAR(locked_demands(1, 1, 1e-10).forward / 1e-10, 1, roundoff);
  EXPECT_NEAR(locked_demands(1e-170, 1e-170, pi / 2).backward / 1e-170, std::sqrt(2), 10 * roundoff);
}

TEST(StickDemands, FirstSlipTakesTheWorseDirectionAndShakedownTheMean) {
  for (const StickDemands demands : {StickDemands{0.2, 0.5}, {0.5, 0.2}}) {
    EXPECT_EQ(first_slip_demand(demands), 0.5);
    EXPECT_EQ(shakedown_demand(demands), 0.35);
  }
  EXPECT_EQ(first_slip_demand(unlocked_demands(0.25, 0.5)), 0.75);
  EXPECT_EQ(shakedown_demand(unlocked_demands(0.25, 0.5)), 0.75);
}

}  // namespace
}  // namespace fretval::mdr::stick_demands_test
