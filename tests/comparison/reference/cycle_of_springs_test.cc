#include "comparison/reference/cycle_of_springs.h"

#include <gtest/gtest.h>

#include "mdr/springs/path_data.h"
#include "tests/comparison/suite_case.h"

namespace fretval::cycle_of_springs_test {
namespace {

TEST(CycleOfSprings, IsThatOfALockedMotionThatMovesTangentially) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  EXPECT_TRUE(cycle_to_step(mdr_case(scene)));
  scene.motion.tangential_amplitude = 0;
  EXPECT_FALSE(cycle_to_step(mdr_case(scene)));
}

// Sliding along the whole path of the indenter, four amplitudes a cycle, under the largest friction.
TEST(CycleOfSprings, KnowsWhatSlidingWouldCost) {
  const auto scene = suite_case("parabola-elastic-steady", 1e-2);
  const double force = 2;
  const auto cycle = cycle_of_springs(mdr_case(scene), {}, force).value();
  EXPECT_DOUBLE_EQ(cycle.sliding_force, scene.friction_coefficient * force);
  EXPECT_DOUBLE_EQ(cycle.sliding_work, cycle.sliding_force * 4 * scene.motion.tangential_amplitude);
}

// An error of 0 is that of a closed form. The largest force is left out where few springs do not know it.
TEST(CycleOfSprings, HasTheErrorsOfSprings) {
  auto mdr = mdr_case(suite_case("parabola-elastic-steady", 1e-2));
  mdr::SteppedForcedResponse stepped{};
  stepped.error.tangential_force_max = 1;
  stepped.error.tangential_force_mean = 2;
  stepped.error.tangential_work = 3;
  auto cycle = cycle_of_springs(mdr, stepped, 2).value();
  EXPECT_EQ(cycle.uncertainty(Quantity::tangential_force_max), 2);
  EXPECT_FALSE(cycle.readings.at(Quantity::friction_work).uncertainty);
  EXPECT_EQ(cycle.uncertainty(Quantity::tangential_force_mean), 2);
  EXPECT_EQ(cycle.uncertainty(Quantity::tangential_work), 3);
  mdr.body.viscosity = 1;
  leave_out_unknown_force(mdr, cycle);
  EXPECT_EQ(cycle.readings.count(Quantity::tangential_force_max), 0U);
}

// In a pass nobody tells what the body has lost from what it stores.
TEST(CycleOfSprings, OfAPathHasWorksIfItRepeats) {
  auto mdr = mdr_case(suite_case("parabola-elastic-steady", 1e-2));
  mdr::PathForces forces{};
  forces.bulk_work = forces.tangential_work = forces.tangential_way = 3;
  EXPECT_EQ(cycle_along(mdr, forces, {}, 2).value(Quantity::bulk_work), 3);
  mdr.motion_kind = MotionKind::pass;
  const auto pass = cycle_along(mdr, forces, {}, 2);
  EXPECT_EQ(pass.value(Quantity::bulk_work) + pass.value(Quantity::tangential_work), 0);
  EXPECT_DOUBLE_EQ(pass.sliding_work, 3 * pass.sliding_force);
}

// The error that a force leads to is taken over what it leads to, the largest of all counts.
TEST(CycleOfSprings, TakesWhatForcesLeadTo) {
  auto mdr = mdr_case(suite_case("parabola-elastic-steady", 1e-2));
  mdr.normal_force = mdr.tangential_force = true;
  mdr::PathForces found{}, error{};
  found.largest_indentation = 1e-4;
  found.tangential_amplitude = 2e-5;
  error.largest_indentation = 2e-6;
  error.tangential_amplitude = 1e-6;
  MdrAnswer answer{};
  take_depths(mdr, {2.5e-5, 0}, {1e-6, 3e-6}, found, error, answer);
  EXPECT_NEAR(mdr::transform(mdr.profile, answer.stick_radius_first_slip.value()), 2.5e-5, 1e-15);
  EXPECT_FALSE(answer.stick_radius_shakedown);
  EXPECT_EQ(answer.indentation_max, 1e-4);
  EXPECT_DOUBLE_EQ(answer.stepping_error, 0.03);
  EXPECT_EQ(answer.stepped.indentation, 2e-6);
  const double c = answer.stick_radius_first_slip.value();  // of a parabola, where g ~ c^2
  EXPECT_NEAR(answer.stepped.first_slip / c, 0.5e-6 / 2.5e-5, 1e-3);
  EXPECT_NEAR(mdr::transform(mdr.profile, answer.stepped.shakedown), 3e-6, 1e-15) << "so much may stick";
  take_tangential_amplitude(mdr, found, error, answer);
  EXPECT_EQ(answer.tangential_amplitude, 2e-5);
  EXPECT_DOUBLE_EQ(answer.stepping_error, 0.05);
  EXPECT_EQ(answer.stepped.tangential_amplitude, 1e-6);
  take_depths(mdr, {2.5e-5, -4e-6}, {2.5e-5, 3e-6}, found, error, answer);
  EXPECT_NEAR(answer.stepped.first_slip, c, 1e-15) << "nothing may stick";
  EXPECT_EQ(answer.stepped.shakedown, 0);
}

// Springs of a layer whose contact sticks to its edge read that a little beyond it.
TEST(CycleOfSprings, StickNoFartherThanTheContact) {
  auto mdr = mdr_case(suite_case("parabola-elastic-steady", 1e-2));
  mdr.layer = mdr::Layer{1e-3, 0.5};
  mdr::PathForces found{}, error{};
  found.largest_indentation = 1e-4;
  MdrAnswer answer{};
  const double a = mdr::inverse_transform(mdr.profile, 5e-5);
  answer.contact_radius_max = a;
  take_depths(mdr, {4e-5, 5.01e-5}, {0, 0}, found, error, answer);
  EXPECT_LT(answer.stick_radius_first_slip.value(), a);
  EXPECT_EQ(answer.stick_radius_shakedown, a);
}

}  // namespace
}  // namespace fretval::cycle_of_springs_test
