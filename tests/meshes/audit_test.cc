#include "meshes/audit.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/meshes/block.h"
#include "tests/meshes/expect_error.h"

namespace fretval::meshes::audit_test {
namespace {

void expect_defect(const Mesh& mesh, std::vector<std::string> parts) {
  parts.emplace_back("block.msh: ");
  expect_error([&mesh] { audit(mesh, "block.msh"); }, parts);
}

TEST(Audit, PassesAGoodMesh) {
  EXPECT_NO_THROW(audit(block(), "block.msh"));
}

TEST(Audit, FindsAnEmptyMesh) {
  expect_defect({}, {"0 cells", "at least 1"});
}

TEST(Audit, FindsIndicesOutOfRange) {
  Mesh mesh = block();
  mesh.cells[3][2] = 9;
  expect_defect(mesh, {"cell 3 has node 9", "below the number of nodes 9"});
  mesh = block();
  mesh.edges[5].nodes[1] = 4000000000U;
  expect_defect(mesh, {"edge 5 has node 4000000000", "below the number of nodes 9"});
}

TEST(Audit, FindsCoordinatesOutsideTheBody) {
  Mesh mesh = block();
  mesh.nodes[4][1] = std::numeric_limits<double>::quiet_NaN();
  expect_defect(mesh, {"node 4 at (1, nan)", "finite"});
  mesh.nodes[4][1] = std::numeric_limits<double>::infinity();
  expect_defect(mesh, {"node 4 at (1, inf)", "finite"});
  mesh = block();
  mesh.nodes[3][0] = -0.1;
  expect_defect(mesh, {"node 3 at (-0.1, -1)", "r = -0.1", "at least 0"});
  mesh = block();
  mesh.nodes[8][1] = 0.25;
  expect_defect(mesh, {"node 8 at (2, 0.25)", "z = 0.25", "at most 0"});
}

TEST(Audit, FindsAnInvertedCell) {
  Mesh mesh = block();
  mesh.cells[1] = {1, 4, 5, 2};
  expect_defect(mesh, {"cell 1 around (1.5, -1.5)", "inverted", "Jacobian -1", "positive"});
}

TEST(Audit, FindsABowTie) {
  Mesh mesh = block();
  mesh.cells[1] = {1, 2, 4, 5};
  expect_defect(mesh, {"cell 1 around (1.5, -1.5)", "bow-tie", "positive"});
}

TEST(Audit, FindsACellThatIsNotConvex) {
  Mesh mesh = block();
  mesh.nodes[4] = {1.9, -1.9};
  expect_defect(mesh, {"cell 1", "not convex", "positive"});
}

TEST(Audit, FindsACollapsedCell) {
  Mesh mesh = block();
  mesh.cells[1] = {1, 2, 2, 4};
  expect_defect(mesh, {"cell 1", "collapsed", "positive"});
  mesh = block();
  mesh.nodes[4] = {1., -2.};
  expect_defect(mesh, {"cell 0", "collapsed", "positive"});
}

TEST(Audit, FindsADuplicateCell) {
  Mesh mesh = block();
  mesh.cells.push_back({5, 4, 1, 2});
  expect_defect(mesh, {"cell 4 around (1.5, -1.5)", "nodes 1, 2, 4, 5 of cell 1", "must have its own"});
}

TEST(Audit, FindsDuplicateNodes) {
  Mesh mesh = block();
  mesh.nodes.push_back({1., -1. + 1e-9});
  mesh.cells[3][0] = 9;
  expect_defect(mesh, {"node 9 at (1, -0.9", "from node 4", "must be more than 9.99999999e-07"});
}

TEST(Audit, FindsANodeThatNoCellUses) {
  Mesh mesh = block();
  mesh.nodes.push_back({0.3, -0.3});
  expect_defect(mesh, {"node 9 at (0.3, -0.3)", "used by 0 cells", "at least 1"});
}

// Cells 0 and 1 are replaced by a single one: node 4 hangs in the middle of its upper edge, node 1 goes.
TEST(Audit, FindsAHangingNode) {
  using B = Boundary;
  const Mesh mesh{{{0, -2}, {2, -2}, {0, -1}, {1, -1}, {2, -1}, {0, 0}, {1, 0}, {2, 0}},
                  {{0, 1, 4, 2}, {2, 3, 6, 5}, {3, 4, 7, 6}},
                  {{{0, 2}, B::axis},
                   {{2, 5}, B::axis},
                   {{5, 6}, B::contact},
                   {{6, 7}, B::free},
                   {{7, 4}, B::far},
                   {{4, 1}, B::far},
                   {{1, 0}, B::far}}};
  expect_defect(mesh, {"edge from node 2 at (0, -1) to node 3 at (1, -1)", "1 cell", "hanging node"});
}

TEST(Audit, FindsAnEdgeInNoPartOfTheBoundary) {
  Mesh mesh = block();
  mesh.edges.erase(mesh.edges.begin() + 5);
  expect_defect(mesh, {"edge from node 2 at (2, -2) to node 5 at (2, -1)", "no part of the boundary"});
}

TEST(Audit, FindsAnEdgeInTwoParts) {
  Mesh mesh = block();
  mesh.edges.push_back({{8, 7}, Boundary::contact});
  expect_defect(mesh, {"contact edge 8 from node 8 at (2, 0) to node 7 at (1, 0)", "free edge 3", "one part"});
}

TEST(Audit, FindsABoundaryEdgeInsideTheBody) {
  Mesh mesh = block();
  mesh.edges.push_back({{4, 5}, Boundary::far});
  expect_defect(mesh, {"far edge 8 from node 4", "belongs to 2 cells", "must be 1"});
  mesh.edges.back().nodes = {0, 8};
  expect_defect(mesh, {"far edge 8 from node 0", "belongs to 0 cells", "must be 1"});
}

TEST(Audit, FindsAnEdgeOfThreeCells) {
  Mesh mesh = block();
  mesh.nodes.push_back({1.2, -0.4});
  mesh.nodes.push_back({1.8, -0.4});
  mesh.cells.push_back({4, 5, 10, 9});
  expect_defect(mesh, {"edge from node 4 at (1, -1) to node 5 at (2, -1)", "3 cells", "at most 2"});
}

TEST(Audit, FindsAMissingPartOfTheBoundary) {
  for (const Boundary missing : all_boundaries) {
    Mesh mesh = block();
    for (auto& edge : mesh.edges)
      if (edge.boundary == missing) edge.boundary = missing == Boundary::far ? Boundary::free : Boundary::far;
    expect_defect(mesh, {boundary_name(missing) + " has 0 edges", "at least 1"});
  }
}

TEST(Audit, FindsAnAxisOffTheAxis) {
  Mesh mesh = block();
  mesh.nodes[3][0] = 1e-15;
  expect_defect(mesh, {"axis edge 0", "node 3 at (1e-15, -1)", "r = 1e-15", "r = 0 exactly"});
}

TEST(Audit, FindsAnEdgeOnTheAxisThatIsNotAxis) {
  Mesh mesh = block();
  mesh.edges[0].boundary = Boundary::far;
  expect_defect(mesh, {"far edge 0 from node 0 at (0, -2) to node 3 at (0, -1)", "r = 0", "must be axis"});
}

TEST(Audit, FindsAContactLineOffTheSurface) {
  Mesh mesh = block();
  mesh.nodes[7][1] = -0.1;
  expect_defect(mesh, {"contact edge 2", "node 7 at (1, -0.1)", "z = -0.1", "z = 0 exactly"});
}

TEST(Audit, FindsAContactLineWithGaps) {
  Mesh mesh = block();
  std::swap(mesh.edges[2].boundary, mesh.edges[3].boundary);
  expect_defect(mesh, {"contact line", "from r = 0 to 1", "without gaps"});
}

TEST(Audit, FindsABodyInTwoParts) {
  Mesh mesh = block();
  for (const auto& node : {std::array<double, 2>{5, -2}, {6, -2}, {6, -1}, {5, -1}}) mesh.nodes.push_back(node);
  mesh.cells.push_back({9, 10, 11, 12});
  for (unsigned i = 0; i < 4; ++i) mesh.edges.push_back({{9 + i, 9 + (i + 1) % 4}, Boundary::far});
  expect_defect(mesh, {"walk around the boundary", "8 of its 12 edges", "one part without holes"});
}

TEST(Audit, FindsPartsThatTouchInOneNode) {
  Mesh mesh = block();
  for (const auto& node : {std::array<double, 2>{3, -3}, {4, -3}, {4, -2}}) mesh.nodes.push_back(node);
  mesh.cells.push_back({2, 9, 10, 11});
  mesh.edges.push_back({{2, 9}, Boundary::far});
  mesh.edges.push_back({{9, 10}, Boundary::far});
  mesh.edges.push_back({{10, 11}, Boundary::far});
  mesh.edges.push_back({{11, 2}, Boundary::far});
  expect_defect(mesh, {"node 2 at (2, -2)", "on 4 edges of the boundary", "0 or 2"});
}

// A fifth cell on the right edge of cell 3, folded back over it instead of to the outside.
TEST(Audit, FindsOverlappingCells) {
  Mesh mesh = block();
  mesh.nodes.push_back({1.2, -0.1});
  mesh.nodes.push_back({1.2, -0.9});
  mesh.cells.push_back({8, 9, 10, 5});
  mesh.edges[4] = {{8, 9}, Boundary::far};
  mesh.edges.push_back({{9, 10}, Boundary::far});
  mesh.edges.push_back({{10, 5}, Boundary::far});
  expect_defect(mesh, {"cells have an area of 4.72", "3.28", "overlap"});
}

}  // namespace
}  // namespace fretval::meshes::audit_test
