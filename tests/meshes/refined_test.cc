#include "meshes/refined.h"

#include <gtest/gtest.h>

#include "meshes/audit.h"
#include "meshes/quality.h"
#include "tests/meshes/block.h"

namespace fretval::meshes::refined_test {
namespace {

TEST(Refined, HasFourCellsForEachAndTheSameBody) {
  Mesh mesh = block();
  mesh.materials = {"pad", "skin"};
  mesh.material = {0, 0, 1, 1};
  const Mesh fine = refined(mesh);
  EXPECT_NO_THROW(audit(fine, "refined block"));
  EXPECT_EQ(fine.cells.size(), 16U);
  EXPECT_EQ(fine.nodes.size(), 25U);
  EXPECT_DOUBLE_EQ(quality(fine).area, quality(mesh).area);
  for (const Boundary boundary : all_boundaries)
    EXPECT_DOUBLE_EQ(boundary_length(fine, boundary), boundary_length(mesh, boundary));
  EXPECT_EQ(contact_radii(fine), (std::vector<double>{0, 0.5, 1}));
  ASSERT_EQ(fine.material.size(), fine.cells.size());
  for (std::size_t i = 0; i < fine.cells.size(); ++i) {
    double z = 0;
    for (const unsigned node : fine.cells[i]) z += fine.nodes[node][1] / 4;
    EXPECT_EQ(fine.material[i], z > -1 ? 1U : 0U) << i;
  }
}

TEST(Refined, SplitsTrianglesIntoThree) {
  const MixedMesh triangle{{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}, {{{0, 1}, Boundary::base}}, {"pad"}, {0}};
  const Mesh mesh = split(triangle);
  EXPECT_EQ(mesh.cells.size(), 3U);
  EXPECT_DOUBLE_EQ(quality(mesh).area, 0.5);
  EXPECT_EQ(mesh.edges.size(), 2U);
  EXPECT_EQ(mesh.material, (std::vector<unsigned>{0, 0, 0}));
}

}  // namespace
}  // namespace fretval::meshes::refined_test
