#include "fem/history/cycle_jump.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace fretval::fem::cycle_jump_test {
namespace {

TEST(LongestCreepTime, IsExactForOneBranchAndForADashpot) {
  EXPECT_DOUBLE_EQ(longest_creep_time({2, {6}, {0.5}, 0}), 0.5 * (1 + 6 / 2.0));
  EXPECT_DOUBLE_EQ(longest_creep_time({2, {}, {}, 3}), 1.5);
  EXPECT_EQ(longest_creep_time({1, {}, {}, 0}), 0);
}

TEST(ChangeToCome, IsTheSumOfWhatDiesOut) {
  double sum = 0;
  for (int k = 1; k < 5000; ++k) sum += std::exp(-k / 100.0);
  EXPECT_NEAR(change_to_come(1e-3, 100), 1e-3 * sum, 1e-12 * sum);
  EXPECT_EQ(change_to_come(1e-3, 0), 1e-3);
  EXPECT_EQ(change_to_come(1e-3, 0.1), 1e-3);
}

// A contact that a jump had opened was taken for periodic because nothing changed in the next period.
TEST(ChangeToCome, IsNotNoneWhereRoundoffHidesIt) {
  EXPECT_GT(change_to_come(0, 1e12), 1e-4);
  EXPECT_LT(change_to_come(0, 1e5), 1e-9);
}

/// Periods until x -> q x + (1 - q) is within 1e-6 of its fixed point 1, for each entry with a rate of its own.
int periods_to_settle(double slowest) {
  const std::array<double, 2> q{0.2, 0.99};
  RingState state{Eigen::VectorXd::Zero(2), Eigen::MatrixXd::Zero(2, 0)};
  CycleJump jump(slowest);
  double indenter = 0;  // with the rate of the slower one
  int n = 0;
  for (; n < 10000 && (state.displacement.array() - 1).abs().maxCoeff() > 1e-6; ++n) {
    for (Eigen::Index i = 0; i < 2; ++i) state.displacement[i] += (1 - q[i]) * (1 - state.displacement[i]);
    indenter += (1 - q[1]) * (1 - indenter);
    jump.advance(state, indenter);
  }
  EXPECT_NEAR(indenter, state.displacement[1], 1e-14);
  return n;
}

// 335 periods with jumps, 1375 without.
TEST(CycleJump, ShortensASlowCreep) {
  EXPECT_LT(periods_to_settle(100), 500);
  EXPECT_GT(periods_to_settle(1), 1000);
}

TEST(CycleJump, LeavesAStateWithoutDriftWhereItIs) {
  RingState state{Eigen::VectorXd::Ones(3), Eigen::MatrixXd::Ones(3, 2)};
  CycleJump jump(1e4);
  double indenter = 2;
  for (int k = 0; k < 10; ++k) jump.advance(state, indenter);
  EXPECT_EQ(indenter, 2);
  EXPECT_EQ(state.displacement, Eigen::VectorXd(Eigen::VectorXd::Ones(3)));
  EXPECT_EQ(state.memory, Eigen::MatrixXd(Eigen::MatrixXd::Ones(3, 2)));
}

}  // namespace
}  // namespace fretval::fem::cycle_jump_test
