#include "meshes/smoothing.h"

#include <gtest/gtest.h>

#include "meshes/quality.h"
#include "tests/meshes/block.h"

namespace fretval::meshes::smoothing_test {
namespace {

TEST(Smooth, MovesAnInnerNodeToTheMeanOfItsNeighbours) {
  Mesh mesh = block();
  mesh.nodes[4] = {1.9, -1.9};
  ASSERT_LT(quality(mesh).min_scaled_jacobian, 0.);
  smooth(mesh);
  EXPECT_DOUBLE_EQ(mesh.nodes[4][0], 1.);
  EXPECT_DOUBLE_EQ(mesh.nodes[4][1], -1.);
}

// Those across a cell do not count.
TEST(Smooth, KnowsNeighboursByTheirEdges) {
  Mesh mesh = block();
  mesh.nodes[8] = {2.5, 0.5};
  mesh.nodes[4] = {1.9, -1.9};
  smooth(mesh);
  EXPECT_DOUBLE_EQ(mesh.nodes[4][0], 1.);
  EXPECT_DOUBLE_EQ(mesh.nodes[4][1], -1.);
}

TEST(Smooth, LeavesGoodCellsAlone) {
  Mesh mesh = block();
  mesh.nodes[4] = {1.5, -1.};
  const auto before = mesh.nodes;
  smooth(mesh);
  EXPECT_EQ(mesh.nodes, before);
}

TEST(Smooth, LeavesTheBoundaryAlone) {
  Mesh mesh = block();
  mesh.nodes[7] = {1.9, 0.};
  const auto before = mesh.nodes;
  smooth(mesh);
  for (const unsigned node : {0, 1, 2, 3, 5, 6, 7, 8}) EXPECT_EQ(mesh.nodes[node], before[node]) << node;
}

}  // namespace
}  // namespace fretval::meshes::smoothing_test
