#include "fem/condensation/mumps.h"

#include <gtest/gtest.h>

namespace fretval::fem::mumps_test {
namespace {

TEST(Mumps, ItsCodesMeanSomething) {
  EXPECT_NE(explain_mumps(-10, 3).find("singular (MUMPS INFOG(1) = -10, INFOG(2) = 3); check"), std::string::npos);
  for (const int code : {-13, -19}) {
    EXPECT_NE(explain_mumps(code, 0).find("out of memory"), std::string::npos);
    EXPECT_NE(explain_mumps(code, 0).find("coarser mesh"), std::string::npos);
  }
  EXPECT_EQ(explain_mumps(-3, 7), "MUMPS INFOG(1) = -3, INFOG(2) = 7");
  for (const int code : {-8, -9}) EXPECT_TRUE(needs_more_work_space(code));
  for (const int code : {0, -10, -13}) EXPECT_FALSE(needs_more_work_space(code));
}

TEST(Mumps, OneTriangleBecomesBoth) {
  Eigen::MatrixXd whole(3, 3);
  whole << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  Eigen::MatrixXd lower = whole.triangularView<Eigen::Lower>(), upper = whole.triangularView<Eigen::Upper>();
  fill_symmetric(lower);
  fill_symmetric(upper);
  EXPECT_EQ(lower, whole);
  EXPECT_EQ(upper, whole);
}

TEST(Mumps, AProbeLoadsEveryDof) {
  const auto load = probe_load(1000);
  EXPECT_GT(load.cwiseAbs().minCoeff(), 1e-5);
  EXPECT_NE(load, Eigen::VectorXd(load.reverse()));
  EXPECT_NE(explain_residual(0.5).find("5.0e-01"), std::string::npos);
}

}  // namespace
}  // namespace fretval::fem::mumps_test
