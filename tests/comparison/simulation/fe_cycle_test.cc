#include "comparison/simulation/fe_cycle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fem/support/constants.h"
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

// A force in saw teeth, whose peaks no five samples tell.
TEST(FeCycle, HasWhatSingleStepsLeaveOpenInItsUnits) {
  constexpr int n = 24;
  FemCase fem{};
  fem.units = {1, 2, 3, 1};  // 6 N, 12 J
  fem.motion = fem::one_frequency(0.8, 0.2, 0.1, 0.7);
  fem::NormalHistory normal;
  fem::FrictionHistory friction;
  normal.steps_per_cycle = friction.n_steps = n;
  for (auto* zero : {&normal.time, &normal.indentation, &normal.force_beyond, &normal.force_uncertainty,
                     &normal.force_beyond_uncertainty, &friction.force_uncertainty})
    zero->setZero(n);
  normal.force.setConstant(n, 100);
  fem.friction_coefficient = 0.5;
  for (auto* series : {&friction.force, &friction.indenter, &friction.force_off_by_steps}) series->resize(n);
  for (int k = 0; k < n; ++k) {
    friction.force[k] = k % 12 - 3;              // 8 at most; it goes on rising by 1 in a step
    friction.indenter[k] = k < 12 ? k : 24 - k;  // to and fro
    friction.force_off_by_steps[k] = k < 12 ? 0.25 : -0.25;
  }
  const auto cycle = cycle_of(fem, 100, normal, friction).value();
  EXPECT_EQ(cycle.off_by_steps.at(Quantity::tangential_force_max), 1.5);
  for (const auto work :
       {Quantity::tangential_work, Quantity::friction_work, Quantity::bulk_work, Quantity::cycle_work})
    EXPECT_DOUBLE_EQ(cycle.off_by_steps.at(work), 12 * 0.25 * 20) << "22 steps with the error and 2 against it";
  const double peak = cycle.value(Quantity::tangential_force_max);
  EXPECT_NEAR(cycle.between_steps.at(Quantity::tangential_force_max), std::max(peak - 48, 54 - peak), 1e-9);
  EXPECT_EQ(cycle.between_steps.at(Quantity::tangential_work), 0) << "a body without memory, whose forces do not jump";

  // From 8 to -3, where it would have risen by 1: a jump of 12 at the 12th step and at the last one.
  fem.relaxation = {1, {1}, {0.5}, 0};
  friction.n_steps = 21L * n;  // beyond the ramp
  const auto remembering = cycle_of(fem, 100, normal, friction).value();
  const auto move = [](double t) { return 0.1 * std::abs(std::sin(t + 0.7)) * 2 * fem::pi / n; };
  const double one_step = 2 * fem::pi / n, half_way = 11 * one_step,
               largest_move = std::max(move(half_way), move(half_way + one_step));
  for (const auto work :
       {Quantity::tangential_work, Quantity::friction_work, Quantity::bulk_work, Quantity::cycle_work})
    EXPECT_NEAR(remembering.between_steps.at(work), 6 * largest_move * 12, 1e-9);
  EXPECT_NEAR(remembering.between_steps.at(Quantity::tangential_force_mean), 6.0 / n * 6, 1e-12);
}

TEST(FeCycle, TakesOverTheChangeFromOneContactToAnother) {
  auto cycle = some_cycle({10, 0, 5, 0, 5, 0.1});
  add_change(some_cycle({2, 0, 1, 0, 1}), some_cycle({3, 0, 3, 0, 1}), cycle);
  EXPECT_EQ(cycle.value(Quantity::tangential_force_max), 11);
  EXPECT_EQ(cycle.value(Quantity::friction_work), 7);
  EXPECT_EQ(cycle.uncertainty(Quantity::tangential_force_max), 0.1);
}

// Of another mesh also what sliding would take, over which the energies are compared.
TEST(FeCycle, GoesHalfwayWithItsScales) {
  auto cycle = some_cycle({10, 0, 5, 0, 5}), other = some_cycle({20, 0, 6, 0, 5});
  cycle.sliding_force = 1;
  cycle.sliding_work = 2;
  other.sliding_force = 4;
  other.sliding_work = 3;
  go_halfway(other, cycle);
  EXPECT_EQ(cycle.value(Quantity::tangential_force_max), 15);
  EXPECT_EQ(cycle.sliding_force, 2.5);
  EXPECT_EQ(cycle.sliding_work, 2.5);
}

}  // namespace
}  // namespace fretval::fe_cycle_test
