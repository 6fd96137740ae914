#include "fem/full_contact/slip_room.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem::slip_room_test {
namespace {

using Eigen::VectorXd;

TEST(SlipRoom, OfOneDirectionIsTheMarginOfTheRingContact) {
  const VectorXd phase = VectorXd::LinSpaced(30, 0, 6), t = 0.4 * phase.array().sin() + 0.1,
                 limit = 1 + 0.3 * phase.array().cos();
  const double expected = ((limit - t).minCoeff() + (limit + t).minCoeff()) / 2;
  EXPECT_NEAR(slip_room(t, VectorXd::Zero(30), limit), expected, 1e-7);
  EXPECT_NEAR(slip_room(VectorXd::Constant(30, 0.7), t, limit), expected, 1e-7);
}

TEST(SlipRoom, OfACircleIsWhatItsRadiusLeaves) {
  const VectorXd phase = VectorXd::LinSpaced(48, 0, 2 * pi * 47 / 48);
  const VectorXd x = 0.5 + 0.3 * phase.array().cos(), y = 0.3 * phase.array().sin() - 2;
  EXPECT_NEAR(slip_room(x, y, VectorXd::Ones(48)), 0.7, 1e-7);
}

TEST(SlipRoom, OfAPointThatHoldsStillIsItsLeastLimit) {
  EXPECT_NEAR(slip_room(VectorXd::Ones(3), VectorXd::Ones(3), Eigen::Vector3d(2, 1, 3)), 1, 1e-12);
}

}  // namespace
}  // namespace fretval::fem::slip_room_test
