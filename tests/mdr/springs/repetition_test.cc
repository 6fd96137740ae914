#include "mdr/springs/repetition.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

// The second of three springs is the innermost one that slips by more than is allowed.
TEST(StillSettles, WhereTheInnermostSpringThatSlipsDoesSoEverLess) {
  const auto after = [](int n_periods, double factor, double allowed = 0.1) {
    std::vector<Eigen::ArrayXd> slips;
    for (int k = 0; k < n_periods; ++k) slips.push_back(Eigen::Array3d(0, std::pow(factor, k), 1));
    return still_settles(slips, allowed);
  };
  EXPECT_TRUE(after(11, 0.9));
  EXPECT_FALSE(after(10, 0.9)) << "too early to tell";
  EXPECT_TRUE(after(11, std::pow(0.98, 0.1)));
  EXPECT_FALSE(after(11, std::pow(0.995, 0.1))) << "hardly any more";
  EXPECT_FALSE(after(11, 1));
  EXPECT_FALSE(after(11, 0.9, 0.5)) << "the third one slips on";
  EXPECT_FALSE(after(11, 0.9, 2)) << "nothing slips";
  const auto with_rises = [](const std::vector<std::size_t>& rises) {
    std::vector<Eigen::ArrayXd> slips(11, Eigen::Array3d(0, 1, 1));
    for (std::size_t k = 1; k < slips.size(); ++k) slips[k][1] = 0.9 * slips[k - 1][1];
    for (const auto k : rises) slips[k][1] = slips[k - 1][1];
    return still_settles(slips, 0.1);
  };
  EXPECT_TRUE(with_rises({5}));
  EXPECT_FALSE(with_rises({5, 8})) << "not from period to period";
}

}  // namespace
}  // namespace fretval::mdr
