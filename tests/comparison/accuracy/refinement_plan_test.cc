#include "comparison/accuracy/refinement_plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace fretval {
namespace {

constexpr double tolerance = 1e-3;
constexpr FixedByCase free_to_choose{false, false};
const Resolution start = resolution_for(1e-3);
const Effort effort{3e4, 28, 1000};  // the body takes most of the time

/// Shares in tolerances.
BarToMeet bar(std::initializer_list<ErrorShare> shares) {
  BarToMeet bar{{shares}, tolerance};
  for (auto& share : bar.bar.shares) share.estimate *= tolerance;
  return bar;
}

ErrorShare share(ErrorSource source, double tolerances, std::optional<double> order = std::nullopt) {
  return {source, tolerances, order};
}

std::optional<Resolution> plan(const std::vector<BarToMeet>& bars, const FixedByCase& fixed = free_to_choose) {
  return planned_refinement(start, bars, effort, fixed);
}

TEST(PlannedRefinement, IsNoneWhereAllBarsMeetTheirTolerances) {
  EXPECT_FALSE(plan({bar({share(ErrorSource::rings, 0.6), share(ErrorSource::time_step, 0.3)})}));
}

TEST(PlannedRefinement, IsOfTheSourceThatIsTooWideAsOftenAsItsOrderAsks) {
  Resolution expected = start;
  expected.steps_per_cycle *= 2;
  EXPECT_TRUE(plan({bar({share(ErrorSource::time_step, 3, 2)})}) == expected);  // 3/4 left
  expected.steps_per_cycle *= 2;
  EXPECT_TRUE(plan({bar({share(ErrorSource::time_step, 10, 2)})}) == expected);  // 10/16
  expected.steps_per_cycle = 3 * start.steps_per_cycle / 2;
  EXPECT_TRUE(plan({bar({share(ErrorSource::time_step, 2, 2)})}) == expected);  // 2/2.25
}

TEST(PlannedRefinement, TakesTheCheapestOfThoseThatAreEnough) {
  // Either would do: a far radius of twice the size is nearly free.
  Resolution expected = start;
  expected.far_radius *= 2;
  EXPECT_TRUE(plan({bar({share(ErrorSource::rings, 0.7), share(ErrorSource::far_field, 0.7)})}) == expected);
}

TEST(PlannedRefinement, MeetsAllBarsAtOnce) {
  const auto planned =
      plan({bar({share(ErrorSource::time_step, 3, 2)}), bar({share(ErrorSource::far_field, 1.5)}), bar({})});
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->steps_per_cycle, 2 * start.steps_per_cycle);
  EXPECT_EQ(planned->far_radius, 2 * start.far_radius);
  EXPECT_EQ(planned->elements_per_radius, start.elements_per_radius);
}

// What is left of a bar by a fiftieth is not worth four times the angles of the full contact, which take more than
// rings half as wide.
TEST(PlannedRefinement, KnowsWhatAnglesTake) {
  const Effort of_full{3e4, 28, 600, 16};
  const auto planned = planned_refinement(start,
                                          {bar({share(ErrorSource::time_step, 1.2, 2.2), share(ErrorSource::edge, 0.82),
                                                share(ErrorSource::rings, 0.12), share(ErrorSource::angles, 0.02)})},
                                          of_full, free_to_choose);
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->n_angles, start.n_angles);
  EXPECT_GT(planned->elements_per_radius, start.elements_per_radius);
}

TEST(PlannedRefinement, RefinesRingsForTheReadingOfEdges) {
  const auto planned = plan({bar({share(ErrorSource::edge, 3)})});
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->elements_per_radius, 2 * start.elements_per_radius);
}

TEST(PlannedRefinement, GoesAsFarAsItMayWhereAnErrorIsUnknown) {
  const auto planned = plan({bar({share(ErrorSource::rings, std::numeric_limits<double>::infinity())})});
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->elements_per_radius, 4 * start.elements_per_radius);
}

TEST(PlannedRefinement, CostsNoMoreThanItMay) {
  const std::vector<BarToMeet> bars{bar({share(ErrorSource::rings, 4)})};
  EXPECT_TRUE(planned_refinement(start, bars, effort, free_to_choose, 2));
  EXPECT_FALSE(planned_refinement(start, bars, effort, free_to_choose, 1.2));
}

TEST(PlannedRefinement, LeavesAloneWhatTheCaseFixesAndWhatDoesNotHelp) {
  EXPECT_FALSE(plan({bar({share(ErrorSource::rings, 4)})}, {true, false}));
  EXPECT_FALSE(plan({bar({share(ErrorSource::time_step, 4)})}, {false, true}));
  EXPECT_FALSE(plan({bar({share(ErrorSource::wear_jump, 4)})}));
}

}  // namespace
}  // namespace fretval
