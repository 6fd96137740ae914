#include "comparison/simulation/fem_case/resolution.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "tests/comparison/expect_parts.h"

namespace fretval::resolution_test {
namespace {

/// Each differs from the first one in one entry, the focused ones from each other.
std::vector<Resolution> unlike_resolutions() {
  const Resolution first{24, 3, 0.5, 12, 36, 8, 1e-5};
  std::vector<Resolution> all(15, first);
  all[1].elements_per_radius = 48;
  all[2].degree = 2;
  all[3].growth = 0.3;
  all[4].far_radius = 10;
  all[5].steps_per_cycle = 72;
  all[6].n_ramp_cycles = 4;
  all[7].periodicity = 1e-6;
  all[8].n_creep_cycles = 96;
  all[9].worn_edge_ring = 1e-5;
  all[10].surface_growth = 0.1;
  all[11].edge_before_node = 0.5;
  all[12].focus = Focus{0, 0, 0};
  all[13].focus = Focus{0, 0.5, 0};
  all[14].focus = Focus{0, 0.5, 0.01};
  return all;
}

TEST(Resolution, IsEqualOnlyToItself) {
  const auto all = unlike_resolutions();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j) {
      EXPECT_EQ(all[i] == all[j], i == j) << i << " " << j;
      EXPECT_EQ((all[i] < all[j]) + (all[j] < all[i]), i == j ? 0 : 1) << i << " " << j;
    }
}

TEST(Resolution, WithTwiceTheRingsHasTwiceAsManyEverywhere) {
  auto resolution = unlike_resolutions()[14];
  resolution.worn_edge_ring = 1e-3;
  const auto finer = with_rings(resolution, 2);
  EXPECT_EQ(finer.elements_per_radius, 48U);
  EXPECT_EQ(finer.focus->ring, 0.005);
  EXPECT_EQ(finer.focus->outer, resolution.focus->outer);
  EXPECT_LT(finer.worn_edge_ring, resolution.worn_edge_ring);
  EXPECT_LT(finer.surface_growth, resolution.surface_growth);
  EXPECT_TRUE(with_rings(finer, 0.5) == resolution);
  EXPECT_TRUE(with_steps(with_steps(resolution, 1.5), 2.0 / 3) == resolution);
  EXPECT_GE(with_rings(finer, 1e3).worn_edge_ring, 1e-7) << "what the mesher tells apart";
}

TEST(Resolution, IsTold) {
  const auto all = unlike_resolutions();
  EXPECT_EQ(text_of(all[0]), "24 rings, degree 3, growth 0.5, far 12, 36 steps, 8 ramp cycles");
  expect_parts(text_of(all[14]), {text_of(all[0]), "rings of 0.01 from 0 to 0.5"});
}

TEST(Resolution, TellsWhatARefinementChanges) {
  const auto coarse = resolution_for(1e-2);
  auto finer = with_steps(coarse, 2);
  EXPECT_EQ(change_text(coarse, finer), "from " + text_of(coarse) + " to " + text_of(finer));
  finer = coarse;
  finer.n_creep_cycles *= 2;
  EXPECT_EQ(change_text(coarse, finer),
            "from " + text_of(coarse) + ", 24 creep cycles to " + text_of(coarse) + ", 48 creep cycles");
}

TEST(Resolution, IsFinerForASmallerTolerance) {
  const auto coarse = resolution_for(1e-2), usual = resolution_for(1e-3), fine = resolution_for(1e-4);
  EXPECT_LE(coarse.elements_per_radius, usual.elements_per_radius);
  EXPECT_LT(usual.elements_per_radius, fine.elements_per_radius);
  EXPECT_LT(coarse.steps_per_cycle, usual.steps_per_cycle);
  EXPECT_LE(usual.steps_per_cycle, fine.steps_per_cycle);
  EXPECT_GT(usual.periodicity, fine.periodicity);
  EXPECT_EQ(resolution_for(1e-3, false).n_ramp_cycles, 1);
  EXPECT_EQ(resolution_for(5e-3).steps_per_cycle, usual.steps_per_cycle) << "between two, the finer one";
}

// Numbers that differ, so that none can stand in the place of another.
TEST(ResolutionJson, HasEveryNumberUnderItsName) {
  const auto json = resolution_json({24, 3, 0.5, 12, 36, 8, 1e-5});
  const nlohmann::ordered_json wanted{{"elements_per_radius", 24}, {"degree", 3},           {"growth", 0.5},
                                      {"far_radius", 12.},         {"steps_per_cycle", 36}, {"ramp_cycles", 8},
                                      {"periodicity", 1e-5}};
  EXPECT_EQ(json, wanted);
}

TEST(ResolutionJson, HasAFocusIfThereIsOne) {
  Resolution focused{24, 3, 0.5, 12, 36, 8, 1e-5};
  focused.focus = Focus{0.25, 0.5, 0.01};
  const auto json = resolution_json(focused);
  EXPECT_EQ(json.size(), 8U);
  EXPECT_EQ(json["focus"], (nlohmann::ordered_json{{"inner", 0.25}, {"outer", 0.5}, {"ring", 0.01}}));
}

}  // namespace
}  // namespace fretval::resolution_test
