#include "comparison/simulation/surface_wear.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>

#include "comparison/simulation/wear_run.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/shared_bodies.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::surface_wear_test {
namespace {

WornEdge edge_at(const PreparedCase& prepared, double stick_radius) {
  return {stick_radius, widest_wear(prepared.fem, 1)};
}

TEST(SurfaceWear, ResolutionIsThatOfTheCaseFile) {
  const auto prepared = wearing_in_a_circle();
  const auto resolution = resolution_for_surface_wear(prepared.input, prepared.fem.resolution);
  EXPECT_EQ(resolution.elements_per_radius, 16U);
  EXPECT_EQ(resolution.steps_per_cycle, 16);
  EXPECT_EQ(resolution.degree, 5U);
}

// The slip of a circle lags behind its displacement: while the outer rings wear, the traction that they leave turns by
// another angle than that of what sticks, and eats into it. MDR has c = 0.856 a, whatever has worn.
TEST(SurfaceWear, InACircleEatsIntoWhatSticks) {
  const auto prepared = wearing_in_a_circle();
  const auto resolution = resolution_for_surface_wear(prepared.input, prepared.fem.resolution);
  int n_told = 0;
  const auto wear = simulate_surface_wear(prepared.fem, *prepared.input.wear_kinetics, edge_at(prepared, 0.8),
                                          resolution, shared_bodies(), {}, [&](const fem::WearCourse&) { ++n_told; });
  EXPECT_EQ(wear.course.end, fem::WearEnd::nothing_left);
  EXPECT_EQ(n_told, wear.course.n_jumps);
  EXPECT_LT(wear.sticks.radius, 0.82);
  EXPECT_GT(wear.sticks.radius, 0.6);
  EXPECT_GT(wear.course.curve.back().contact_radius, wear.sticks.radius - 1e-12);
  EXPECT_NEAR(wear.sticks.along, wear.sticks.across, 2 * wear.sticks.uncertainty);
  EXPECT_DOUBLE_EQ(wear.sticks.radius, wear.course.curve.back().stick_radius);
  const auto worn = wear.field(wear.course.worn.back());
  EXPECT_EQ(worn.cols(), wear.grid.n_kept());
  EXPECT_EQ(worn.topRows(4).maxCoeff(), 0) << "what sticks does not wear";
}

// What an indenter has lost before is lost at all angles. One that is worn flat by 0.19 of its indentation touches a
// radius of 0.9 where it is pressed in as deep as before, and its centre, which sticks, loses no more.
TEST(SurfaceWear, GoesOnFromWhatHasWornBefore) {
  auto prepared = wearing_in_a_circle();
  prepared.fem.worn_before = WornBefore{[](double) { return 0.19; }, {}};
  auto resolution = resolution_for_surface_wear(prepared.input, prepared.fem.resolution);
  resolution.wear_jump *= 4;
  const auto wear = simulate_surface_wear(prepared.fem, *prepared.input.wear_kinetics, edge_at(prepared, 0.6),
                                          resolution, shared_bodies(), {}, [](const fem::WearCourse&) {});
  EXPECT_NEAR(wear.course.curve.front().contact_radius, 0.9, 1.0 / 16);
  const auto first = wear.field(wear.course.worn.front()), last = wear.field(wear.course.worn.back());
  EXPECT_LT((first.array() - 0.19).abs().maxCoeff(), 1e-12);
  EXPECT_LT((last.topRows(3).array() - 0.19).abs().maxCoeff(), 1e-12);
  EXPECT_GT(last.maxCoeff(), 0.25);
}

// Under a weight the indenter sinks in as it wears, and the circle leaves less to stick than MDR's limit.
TEST(SurfaceWear, SinksInUnderAWeight) {
  const auto prepared = wearing_in_a_circle_under_a_weight();
  auto resolution = resolution_for_surface_wear(prepared.input, prepared.fem.resolution);
  resolution.wear_jump *= 2;
  const auto edge =
      edge_of_surface_wear(prepared.fem, *prepared.input.wear_kinetics, 0.8, resolution, shared_bodies(), {});
  ASSERT_TRUE(prepared.mdr.limiting_state);
  const double limit = prepared.mdr.limiting_state->stick_radius / prepared.fem.units.length;
  EXPECT_LT(edge.inner, limit);
  EXPECT_GT(edge.inner, 0.5);
  EXPECT_GT(prepared.fem.profile(edge.outer), 1.05) << "deeper than the unworn indenter";
}

// A motion across and one along x with the same numbers are two wears.
TEST(SurfaceWear, KeepsACheckpointOfItsOwnForEachDirection) {
  const ScratchFolder folder;
  struct Killed {};
  for (const bool across : {true, false}) {
    auto prepared = wearing_in_a_circle();
    prepared.fem.motion.tangential.back().across = across;
    const auto resolution = resolution_for_surface_wear(prepared.input, prepared.fem.resolution);
    const auto kill = [](const fem::WearCourse&) { throw Killed(); };
    EXPECT_THROW(simulate_surface_wear(prepared.fem, *prepared.input.wear_kinetics, edge_at(prepared, 0.8), resolution,
                                       shared_bodies(), folder.path(), kill),
                 Killed);
  }
  const std::filesystem::directory_iterator begin(folder.path()), end;
  EXPECT_EQ(std::distance(begin, end), 2);
}

}  // namespace
}  // namespace fretval::surface_wear_test
