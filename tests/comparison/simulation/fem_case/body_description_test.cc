#include "comparison/simulation/fem_case/body_description.h"

#include <gtest/gtest.h>

namespace fretval::body_description_test {
namespace {

BodyDescription layer_with(std::vector<double> nodes) {
  BodyDescription layer{std::move(nodes), 0.5, 6, 3};
  layer.poisson_ratio = 0.4;
  layer.thickness = 0.5;
  return layer;
}

std::vector<double> equal_nodes(int n) {
  std::vector<double> nodes;
  for (int i = 0; i <= n; ++i) nodes.push_back(0.03 * i);
  return nodes;
}

TEST(BodyDescription, IsAnotherOneForEveryField) {
  const BodyDescription body{{0, 1}, 0.5, 6, 3};
  std::vector<BodyDescription> others(17, body);
  others[0].contact_nodes = {0, 2};
  others[1].growth = 0.4;
  others[2].far_radius = 7;
  others[3].degree = 2;
  others[4].tangential = false;
  others[5].scale = 2;
  others[6].poisson_ratio = 0.3;
  others[7].thickness = 1;
  others[8].slides_on_base = true;
  others[9].given.file = "rig.msh";
  others[10].given.content = "0123";
  others[11].given.moduli = {1, 8};
  others[12].given.n_refinements = 1;
  others[13].given.radii = {0, 1};
  others[14].moved.factor = 1.01;
  others[15].moved.coarse_nodes = {0, 1};
  others[16].moved.coarse_far_radius = 7;
  EXPECT_FALSE(body < body);
  for (const auto& other : others) EXPECT_TRUE(body < other || other < body);
  EXPECT_EQ(std::tuple_size<decltype(BodyDescription::fields(body))>::value, others.size());
}

// Of equal rings 24 suffice, over their width: so bodies with more or fewer of them, and of any thickness, share one.
TEST(HalfSpaceWithRings, HasTheSameRings) {
  const auto few = half_space_with_rings_of(layer_with(equal_nodes(8)));
  EXPECT_TRUE(few.is_half_space());
  EXPECT_EQ(few.poisson_ratio, 0.4);
  EXPECT_GT(few.far_radius, 2 * few.contact_nodes.back());
  EXPECT_EQ(few.contact_nodes.size(), 25U);
  EXPECT_DOUBLE_EQ(few.scale * few.contact_nodes[5], equal_nodes(8)[5]);
  auto many = half_space_with_rings_of(layer_with(equal_nodes(64)));
  EXPECT_FALSE(few < many || many < few);
  auto other_rings = layer_with({0, 0.05, 0.1, 0.15});
  other_rings.thickness = 2;
  auto wider = half_space_with_rings_of(other_rings);
  EXPECT_EQ(wider.scale, 0.05);
  wider.scale = many.scale;
  EXPECT_FALSE(wider < many || many < wider);
}

// Of others each counts.
TEST(HalfSpaceWithRings, HasEachRingOfThoseThatDiffer) {
  const std::vector<double> graded{0, 0.1, 0.15, 0.18, 0.2, 0.25, 0.4, 1};
  EXPECT_EQ(half_space_with_rings_of(layer_with(graded)).contact_nodes, graded);
}

}  // namespace
}  // namespace fretval::body_description_test
