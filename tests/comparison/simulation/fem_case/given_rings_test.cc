#include "comparison/simulation/fem_case/given_rings.h"

#include <gtest/gtest.h>

#include "comparison/simulation/bodies/body_store.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/given_mesh.h"

namespace fretval {
namespace {

class GivenRings : public testing::Test {
 protected:
  GivenBody given(unsigned n_rings, double length) {
    return given_body(case_with_mesh(folder, pad_mesh(n_rings, true), "  set Relative moduli = skin 8\n"), length);
  }
  static BodyDescription body_of(const GivenBody& given, Resolution resolution, unsigned n_rings,
                                 unsigned n_refinements = 0) {
    resolution.elements_per_radius = n_rings;
    resolution.mesh_refinements = n_refinements;
    BodyDescription body{{}, 0.5, 12, 2};
    take_given(given, 3, resolution, body);
    return body;
  }
  ScratchFolder folder;
  Resolution resolution = resolution_for(1e-2);
};

TEST_F(GivenRings, AreThoseOfTheMesh) {
  const auto rig = given(24, 1e-3);
  EXPECT_EQ(rig.rings_per_radius, 16U);
  EXPECT_DOUBLE_EQ(rig.scale, 1.5);
  EXPECT_EQ(rig.mesh.moduli, (std::vector<double>{1, 8}));
  const auto body = body_of(rig, resolution, 16);
  EXPECT_EQ(body.contact_nodes.size(), 25U);
  EXPECT_EQ(body.contact_nodes.back(), 1);
  EXPECT_FALSE(body.has_merged_rings());
  EXPECT_DOUBLE_EQ(body.thickness, 2);
}

TEST_F(GivenRings, AreNeighboursTogetherWhereTheyAreFewer) {
  const auto rig = given(24, 1e-3);
  const auto half = body_of(rig, resolution, 8), quarter = body_of(rig, resolution, 4);
  EXPECT_EQ(half.contact_nodes.size(), 13U);
  EXPECT_EQ(quarter.contact_nodes.size(), 7U);
  EXPECT_EQ(half.given.n_refinements, 0U);
  EXPECT_EQ(half.given.radii.size(), 25U);
}

TEST_F(GivenRings, ShareTheirCellsWhereTheMeshIsFinerOrHaveThemToThemselves) {
  const auto rig = given(24, 1e-3);
  const auto whole = body_of(rig, resolution, 16), finer_cells = body_of(rig, resolution, 16, 1),
             twice = body_of(rig, resolution, 32);
  EXPECT_EQ(finer_cells.contact_nodes, whole.contact_nodes);
  EXPECT_EQ(finer_cells.given.n_refinements, 1U);
  EXPECT_EQ(twice.contact_nodes.size(), 49U);
  EXPECT_FALSE(twice.has_merged_rings());
  auto elsewhere = resolution;
  elsewhere.edge_before_node += 0.5;
  const auto shifted = body_of(rig, elsewhere, 16, 1);
  EXPECT_EQ(shifted.contact_nodes.size(), 26U);
  EXPECT_DOUBLE_EQ(shifted.contact_nodes[1], whole.contact_nodes[1] / 2);
}

// Rings that are merged are those of the body that they are merged of, radii to the last digit.
TEST_F(GivenRings, AreFoundInTheirBody) {
  const auto rig = given(16, 1e-3);
  BodyStore bodies;
  auto elsewhere = resolution;
  elsewhere.edge_before_node += 0.5;
  const auto body = body_of(rig, elsewhere, rig.rings_per_radius, 1);
  const auto merged = find_or_make_body(body, bodies);
  ASSERT_EQ(merged->summary->radii.size(), body.contact_nodes.size());
  for (std::size_t i = 0; i < body.contact_nodes.size(); ++i)
    EXPECT_NEAR(merged->summary->radii[i], 1.5 * body.contact_nodes[i], 1e-14);
  EXPECT_TRUE(merged->normal.compliance.half_space);
}

TEST_F(GivenRings, MustBeEnoughAndReachBeyondTheContact) {
  expect_parts(refusal([&] { given(8, 1e-3); }),
               {"Body / Mesh", "5 edges within the contact radius", "at least 6", "usually takes 24"});
  expect_parts(refusal([&] { given(32, 1.45e-3); }), {"\"contact\" ends at r = 0.0015 m", "smaller indentation"});
}

TEST_F(GivenRings, AreOfTheFileAsItWasRead) {
  const auto rig = given(16, 1e-3);
  const auto body = body_of(rig, resolution, rig.rings_per_radius);
  std::ofstream(folder.path() / "rig.msh", std::ios::app) << "\n";
  EXPECT_THROW(mesh_of(body), meshes::MeshError);
}

}  // namespace
}  // namespace fretval
