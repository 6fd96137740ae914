#include "comparison/simulation/wear_run.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "fem/contact/require_room.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::wear_run_test {
namespace {

// f = r^2/2 in units of the contact radius and the largest indentation, which is a^2/R.
TEST(WearRun, ReachesToThePlaneOfTheLargestIndentation) {
  const auto fem = wearing_case("  set Coefficient = 1e-12\n").fem;
  const double reach = widest_wear(fem, 1);
  EXPECT_NEAR(fem.profile(reach), 1, 5e-3);
  EXPECT_GE(fem.profile(reach), 1);
  EXPECT_GT(widest_wear(fem, 2), reach);
}

// Under forces the rings are graded anew until the stick radius that wear ends with stays in its ring.
TEST(WearRun, FollowsTheStickRadiusUntilItSettles) {
  const auto prepared = wearing_under_force("set Tangential force amplitude = 0.06");
  std::vector<WornEdge> tried;
  const auto edge = settled_edge(prepared.fem, 0.8, [&](const WornEdge& at) {
    tried.push_back(at);
    if (tried.size() == 1) throw fem::NoRoom("the contact is wider than its rings");
    return WearPass{fem::WearEnd::nothing_left, 1.2, 0.5 + (at.inner - 0.5) / 10, 0.01};
  });
  ASSERT_EQ(tried.size(), 4U) << "without room, from 0.8 to 0.53, to 0.503, to 0.5003";
  EXPECT_EQ(tried[1].inner, 0.8);
  EXPECT_GT(tried[1].outer, tried[0].outer) << "it sinks in deeper";
  EXPECT_NEAR(edge.inner, 0.5003, 1e-12);
  EXPECT_DOUBLE_EQ(edge.outer, widest_wear(prepared.fem, 1.05 * 1.2));
}

TEST(WearRun, HasNoEdgeWhereWearIsProgressive) {
  const auto prepared = wearing_under_force("set Tangential force amplitude = 0.06");
  const auto edge = settled_edge(prepared.fem, 0.8, [](const WornEdge& /*unused*/) {
    return WearPass{fem::WearEnd::progressive, 1.2, 0.5, 0.01};
  });
  EXPECT_EQ(edge.inner, 0);
}

TEST(WearRun, KeepsTheStickRadiusUnderPrescribedDisplacements) {
  const auto prepared = wearing_case("  set Coefficient = 1e-12\n");
  const auto edge = settled_edge(prepared.fem, 0.8, [](const WornEdge& /*unused*/) -> WearPass {
    throw std::logic_error("nothing has to be found out");
  });
  EXPECT_EQ(edge.inner, 0.8);
  EXPECT_DOUBLE_EQ(edge.outer, widest_wear(prepared.fem, 1));
}

}  // namespace
}  // namespace fretval::wear_run_test
