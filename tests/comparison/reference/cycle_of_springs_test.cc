#include "comparison/reference/cycle_of_springs.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace fretval::cycle_of_springs_test
