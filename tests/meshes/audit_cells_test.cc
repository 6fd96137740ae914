#include "meshes/audit_cells.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/meshes/expect_defect.h"

namespace fretval::meshes::audit_cells_test {
namespace {

TEST(AuditCells, PassesAGoodMesh) {
  for (const auto step : {audit_indices, audit_nodes, audit_cells, audit_node_use})
    EXPECT_NO_THROW(step(block(), "block.msh"));
  EXPECT_EQ(describe_node(block(), 3), "node 3 at (0, -1)");
}

TEST(AuditCells, FindsAnEmptyMesh) {
  expect_defect(audit_indices, {}, {"0 cells", "at least 1"});
}

TEST(AuditCells, FindsIndicesOutOfRange) {
  Mesh mesh = block();
  mesh.cells[3][2] = 9;
  expect_defect(audit_indices, mesh, {"cell 3 has node 9", "below the number of nodes 9"});
  mesh = block();
  mesh.edges[5].nodes[1] = 4000000000U;
  expect_defect(audit_indices, mesh, {"edge 5 has node 4000000000", "below the number of nodes 9"});
}

TEST(AuditCells, FindsCoordinatesOutsideTheBody) {
  Mesh mesh = block();
  mesh.nodes[4][1] = std::numeric_limits<double>::quiet_NaN();
  expect_defect(audit_nodes, mesh, {"node 4 at (1, nan)", "finite"});
  mesh.nodes[4][1] = std::numeric_limits<double>::infinity();
  expect_defect(audit_nodes, mesh, {"node 4 at (1, inf)", "finite"});
  mesh = block();
  mesh.nodes[3][0] = -0.1;
  expect_defect(audit_nodes, mesh, {"node 3 at (-0.1, -1)", "r = -0.1", "at least 0"});
  mesh = block();
  mesh.nodes[8][1] = 0.25;
  expect_defect(audit_nodes, mesh, {"node 8 at (2, 0.25)", "z = 0.25", "at most 0"});
}

TEST(AuditCells, FindsAnInvertedCell) {
  Mesh mesh = block();
  mesh.cells[1] = {1, 4, 5, 2};
  expect_defect(audit_cells, mesh, {"cell 1 around (1.5, -1.5)", "inverted", "Jacobian -1", "positive"});
}

TEST(AuditCells, FindsABowTie) {
  Mesh mesh = block();
  mesh.cells[1] = {1, 2, 4, 5};
  expect_defect(audit_cells, mesh, {"cell 1 around (1.5, -1.5)", "bow-tie", "positive"});
}

TEST(AuditCells, FindsACellThatIsNotConvex) {
  Mesh mesh = block();
  mesh.nodes[4] = {1.9, -1.9};
  expect_defect(audit_cells, mesh, {"cell 1", "not convex", "positive"});
}

TEST(AuditCells, FindsACollapsedCell) {
  Mesh mesh = block();
  mesh.cells[1] = {1, 2, 2, 4};
  expect_defect(audit_cells, mesh, {"cell 1", "collapsed", "positive"});
  mesh = block();
  mesh.nodes[4] = {1., -2.};
  expect_defect(audit_cells, mesh, {"cell 0", "collapsed", "positive"});
}

TEST(AuditCells, FindsADuplicateCell) {
  Mesh mesh = block();
  mesh.cells.push_back({5, 4, 1, 2});
  expect_defect(audit_cells, mesh, {"cell 4 around (1.5, -1.5)", "nodes 1, 2, 4, 5 of cell 1", "must have its own"});
}

TEST(AuditCells, FindsDuplicateNodes) {
  Mesh mesh = block();
  mesh.nodes.push_back({1., -1. + 1e-9});
  mesh.cells[3][0] = 9;
  expect_defect(audit_node_use, mesh, {"node 9 at (1, -0.9", "from node 4", "must be more than 9.99999999e-07"});
}

TEST(AuditCells, FindsANodeThatNoCellUses) {
  Mesh mesh = block();
  mesh.nodes.push_back({0.3, -0.3});
  expect_defect(audit_node_use, mesh, {"node 9 at (0.3, -0.3)", "used by 0 cells", "at least 1"});
}

// One corner at a distance of sqrt(2) e from the straight line between its neighbours: Jacobian 4 e.
TEST(AuditCells, FindsACellThatIsATriangleToRoundoff) {
  const auto cell = [](double e) { return Mesh{{{1, -2}, {2, -2}, {2, -1}, {1.5 - e, -1.5 + e}}, {{0, 1, 2, 3}}, {}}; };
  EXPECT_NO_THROW(audit_cells(cell(1e-8), "block.msh"));
  for (const double e : {1e-9, -1e-9}) expect_defect(audit_cells, cell(e), {"cell 0 around", "collapsed"});
  expect_defect(audit_cells, cell(-0.1), {"cell 0 around", "not convex"});
}

// Cell 3 on a node 9 of its own next to node 4, in every direction.
TEST(AuditCells, KnowsNodesCloserThanAMillionthOfTheShortestEdge) {
  for (const auto& [r, z] : {std::array<double, 2>{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
    const auto cut = [r = r, z = z](double gap) {
      Mesh mesh = block();
      mesh.nodes.push_back({1 + gap * r, -1 + gap * z});
      mesh.cells[3][0] = 9;
      return mesh;
    };
    EXPECT_NO_THROW(audit_node_use(cut(1.01e-6), "block.msh"));
    expect_defect(audit_node_use, cut(0.99e-6), {"node 9", "from node 4"});
  }
}

}  // namespace
}  // namespace fretval::meshes::audit_cells_test
