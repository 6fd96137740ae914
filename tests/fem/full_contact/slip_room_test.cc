#include "fem/full_contact/slip_room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fem/support/constants.h"

namespace fretval::fem::slip_room_test {
namespace {

using Eigen::VectorXd;

TEST(SlipRoom, OfOneDirectionIsTheMarginOfTheRingContact) {
  const VectorXd phase = VectorXd::LinSpaced(30, 0, 6), t = 0.4 * phase.array().sin() + 0.1,
                 limit = 1 + 0.3 * phase.array().cos();
  const double expected = ((limit - t).minCoeff() + (limit + t).minCoeff()) / 2;
  EXPECT_NEAR(slip_room(t, VectorXd::Zero(30), limit), expected, 1e-14);
  EXPECT_NEAR(slip_room(VectorXd::Constant(30, 0.7), t, limit), expected, 1e-14);
}

TEST(SlipRoom, OfACircleIsWhatItsRadiusLeaves) {
  const VectorXd phase = VectorXd::LinSpaced(48, 0, 2 * pi * 47 / 48);
  const VectorXd x = 0.5 + 0.3 * phase.array().cos(), y = 0.3 * phase.array().sin() - 2;
  EXPECT_NEAR(slip_room(x, y, VectorXd::Ones(48)), 0.7, 1e-14);
}

/// The largest value of a concave function from -1 to 1, by thirds.
template <class Function>
double largest(const Function& f) {
  double low = -1, high = 1;
  for (int n = 0; n < 60; ++n) {
    const double third = (high - low) / 3;
    if (f(low + third) < f(high - third))
      low += third;
    else
      high -= third;
  }
  return f((low + high) / 2);
}

double room_by_search(const VectorXd& x, const VectorXd& y, const VectorXd& limit) {
  return largest([&](double of_x) {
    return largest([&](double of_y) {
      return (limit.array() - ((x.array() - of_x).square() + (y.array() - of_y).square()).sqrt()).minCoeff();
    });
  });
}

// Tractions anywhere, with limits that hold alone, in pairs or by three.
TEST(SlipRoom, IsTheLargestOfAllOffsets) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int n = 0; n < 100; ++n) {
    const VectorXd x = VectorXd::NullaryExpr(12, [&] { return any(random); }),
                   y = VectorXd::NullaryExpr(12, [&] { return any(random); }),
                   limit = VectorXd::NullaryExpr(12, [&] { return 2 + n / 50.0 * any(random); });
    EXPECT_NEAR(slip_room(x, y, limit), room_by_search(x, y, limit), 1e-8) << n;
  }
}

TEST(SlipRoom, OfAPointThatHoldsStillIsItsLeastLimit) {
  EXPECT_NEAR(slip_room(VectorXd::Ones(3), VectorXd::Ones(3), Eigen::Vector3d(2, 1, 3)), 1, 1e-12);
}

}  // namespace
}  // namespace fretval::fem::slip_room_test
