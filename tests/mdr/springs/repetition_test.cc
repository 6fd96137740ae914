#include "mdr/springs/repetition.h"

#include <gtest/gtest.h>

namespace fretval::mdr {
namespace {

TEST(Repetition, IsReachedAtThePeriodicity) {
  Repetition repetition(elastic(1e6), 1e-5);
  for (const double change : {1.0, 1e-2, 2e-5}) EXPECT_FALSE(repetition.reached(change));
  EXPECT_TRUE(repetition.reached(1e-5));
}

// Ten changes that are no smaller than the one before them, and not too large either.
TEST(Repetition, OfLoadsThatJumpDoesWithoutItWhereChangesFallNoFurther) {
  const auto periods_until = [](const PronyBody& body, double change) {
    Repetition repetition(body, 1e-5);
    int n = 1;
    while (n < 100 && !repetition.reached(change)) ++n;
    return n;
  };
  const auto dashpot = kelvin_voigt(1e6, 1e4);
  EXPECT_EQ(periods_until(dashpot, 9e-3), 11);
  EXPECT_EQ(periods_until(dashpot, 1.1e-2), 100);
  EXPECT_EQ(periods_until(elastic(1e6), 9e-3), 100);

  Repetition falling(dashpot, 1e-5);
  for (int n = 100; n < 150; ++n) EXPECT_FALSE(falling.reached(1. / n));
}

TEST(Repetition, KnowsTheChangeOfBothTractions) {
  SpringState before{}, after{};
  before.normal_load = Eigen::Array2d(4, 1);
  before.tangential_load = Eigen::Array2d(1, -1);
  after = before;
  EXPECT_EQ(change_of_tractions(before, after, 0.5), 0);
  after.tangential_load[1] = -0.9;
  EXPECT_NEAR(change_of_tractions(before, after, 0.5), 0.1 / 2, 1e-15);
  after.normal_load[0] = 3.6;
  EXPECT_NEAR(change_of_tractions(before, after, 0.5), 0.2 / 2, 1e-15);
}

}  // namespace
}  // namespace fretval::mdr
