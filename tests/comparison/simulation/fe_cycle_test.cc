#include "comparison/simulation/fe_cycle.h"

#include <gtest/gtest.h>

#include "tests/comparison/some_cycle.h"

namespace fretval::fe_cycle_test {
namespace {

TEST(FeCycle, IsInTheUnitsOfItsCase) {
  FemCase fem{};
  fem.units = {1, 2, 3, 1};  // 6 N, 12 J
  fem::SurfaceHistory history;
  history.forces = Eigen::Matrix3Xd::Zero(3, 2);
  history.forces.row(0) << 1, -2;
  history.dissipated = {0.5, 1};
  history.tangential_work = 1;
  const auto cycle = cycle_of(fem, history, 0);
  EXPECT_EQ(cycle.value(Quantity::tangential_force_mean), -3);
  EXPECT_EQ(cycle.value(Quantity::friction_work), 12);
  EXPECT_EQ(cycle.value(Quantity::tangential_work), 12);
  EXPECT_EQ(cycle.value(Quantity::bulk_work), 0) << "a body without memory";
  EXPECT_GE(cycle.value(Quantity::tangential_force_max), 12);
}

TEST(FeCycle, TakesOverTheChangeFromOneContactToAnother) {
  auto cycle = some_cycle({10, 0, 5, 0, 5, 0.1});
  add_change(some_cycle({2, 0, 1, 0, 1}), some_cycle({3, 0, 3, 0, 1}), cycle);
  EXPECT_EQ(cycle.value(Quantity::tangential_force_max), 11);
  EXPECT_EQ(cycle.value(Quantity::friction_work), 7);
  EXPECT_EQ(cycle.uncertainty(Quantity::tangential_force_max), 0.1);
}

}  // namespace
}  // namespace fretval::fe_cycle_test
