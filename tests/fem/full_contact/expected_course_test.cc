#include "fem/full_contact/expected_course.h"

#include <gtest/gtest.h>

namespace fretval::fem::expected_course_test {
namespace {

using Eigen::MatrixXd;

// A field that repeats every three steps, and drifts by the same in each.
TEST(ExpectedCourse, IsExactFromTheSecondCycleOnForACycleThatDrifts) {
  const auto field = [](int n) { return MatrixXd::Constant(2, 3, 10.0 * ((n % 3) * (n % 3)) + 0.25 * n); };
  ExpectedCourse course(3);
  for (int n = 0; n < 3; ++n) EXPECT_EQ(course.next(field(n)), field(n)) << n;
  for (int n = 3; n < 9; ++n) EXPECT_EQ(course.next(field(n)), field(n + 1)) << n;
}

}  // namespace
}  // namespace fretval::fem::expected_course_test
