#include "fem/full_contact/turning_slip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fem/support/constants.h"

namespace fretval::fem::turning_slip_test {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;

/// A vector at one point.
MatrixXd vector_at(double angle, double length = 1) {
  return (MatrixXd(1, 2) << length * std::cos(angle), length * std::sin(angle)).finished();
}

// What the slips of the steps add up to is the chord of a quarter of a circle.
TEST(TurningSlip, AddsUpToTheChordInSecondOrder) {
  const auto error = [](int n) {
    const double turn = pi / 2 / n, fraction = 0.8;
    Vector2d sum(0, 0);
    for (int k = 0; k < n; ++k) {
      const double angle = (k + fraction) * turn;
      const MatrixXd along = vector_at(angle, turn),
                     aside = turning_slip(vector_at(angle - turn, turn), vector_at(angle - turn),
                                          vector_at(angle - 2 * turn), fraction);
      sum += (along + aside).row(0).transpose();
    }
    return (sum - Vector2d(1, 1)).norm();
  };
  EXPECT_LT(error(32), 3e-3);
  EXPECT_NEAR(std::log2(error(16) / error(32)), 2, 0.1);
}

// Of each point by its own slip, turn and place in the field; tractions of any length.
TEST(TurningSlip, IsThatOfEachPoint) {
  MatrixXd slip(2, 4), now(2, 4), before(2, 4);
  slip << 0, 0, 3, 4,  //
      1, 0, 0, 0;
  now << 5, 0.01, 0, 0.01,  //
      7, 2, 7, 0;
  before << 0, 3, 5, 0,  //
      9, 2, 0, 0;
  const double cosine = std::sqrt(0.5);
  const MatrixXd aside = turning_slip(slip, now, before, 0.75);
  const auto at = [&](int ring, int angle) { return Vector2d(aside(ring, angle), aside(ring, 2 + angle)); };
  EXPECT_EQ(at(0, 0), Vector2d(0, 0));  // a right angle
  EXPECT_LT((at(0, 1) + 0.25 * cosine * 4 * Vector2d(cosine - 1, cosine)).norm(), 1e-14);
  EXPECT_LT((at(1, 0) + 0.25 * cosine * Vector2d(cosine - 1, cosine)).norm(), 1e-14);
  EXPECT_EQ(at(1, 1), Vector2d(0, 0));  // sticks
}

TEST(TurningSlip, IsNoneInTheMiddleOfTheStepOrAtAReversal) {
  EXPECT_EQ(turning_slip(vector_at(0.2), vector_at(0.2), vector_at(0), 0.5).norm(), 0);
  EXPECT_GT(turning_slip(vector_at(0.2), vector_at(0.2), vector_at(0), 1).norm(), 0.09);
  EXPECT_EQ(turning_slip(vector_at(pi), vector_at(pi), vector_at(0), 1).norm(), 0);
  EXPECT_EQ(turning_slip(vector_at(0.2), vector_at(0.2), vector_at(0, 0), 1).norm(), 0);
}

}  // namespace
}  // namespace fretval::fem::turning_slip_test
