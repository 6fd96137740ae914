#include "fem/full_contact/anderson_mixing.h"

#include <gtest/gtest.h>

namespace fretval::fem::anderson_mixing_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

Vector3d fixed_point() {
  return {1, -2, 0.5};
}

/// An affine map that contracts slowly, by 0.9.
VectorXd image_of(const VectorXd& x) {
  Matrix3d slope;
  slope << 0.9, 0.1, 0, 0, 0.5, 0.2, 0, 0, -0.8;
  return fixed_point() + slope * (x - fixed_point());
}

VectorXd iterated(std::size_t depth, int n) {
  AndersonMixing mixing(depth);
  VectorXd x = VectorXd::Zero(3);
  for (int i = 0; i < n; ++i) x = mixing.next(x, image_of(x));
  return x;
}

TEST(AndersonMixing, FindsTheFixedPointOfAnAffineMapInOneStepMoreThanItHasDimensions) {
  EXPECT_GT((iterated(3, 3) - fixed_point()).norm(), 1e-3);
  EXPECT_LT((iterated(3, 4) - fixed_point()).norm(), 1e-12);
  EXPECT_GT((iterated(2, 4) - fixed_point()).norm(), 1e-6);  // two differences do not span three dimensions
}

TEST(AndersonMixing, OfNoDepthIsThePlainIteration) {
  VectorXd x = VectorXd::Zero(3);
  for (int i = 0; i < 5; ++i) x = image_of(x);
  EXPECT_EQ(iterated(0, 5), x);
}

TEST(AndersonMixing, StaysWhereNothingChanges) {
  AndersonMixing mixing(3);
  VectorXd x = fixed_point();
  for (int i = 0; i < 4; ++i) x = mixing.next(x, x);
  EXPECT_EQ(x, fixed_point());
}

}  // namespace
}  // namespace fretval::fem::anderson_mixing_test
