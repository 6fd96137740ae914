#include "meshes/audit_boundary.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/meshes/expect_defect.h"

namespace fretval::meshes::audit_boundary_test {
namespace {

TEST(AuditBoundary, PassesAGoodMeshInWhateverSenseItsEdgesRun) {
  Mesh mesh = block();
  for (std::size_t flipped = 0; flipped <= mesh.edges.size(); ++flipped) {
    for (const auto step : {audit_edges, audit_parts_of_boundary, audit_contact_line, audit_body})
      EXPECT_NO_THROW(step(mesh, "block.msh")) << flipped;
    if (flipped < mesh.edges.size()) std::swap(mesh.edges[flipped].nodes[0], mesh.edges[flipped].nodes[1]);
  }
}

// Cells 0 and 1 are replaced by a single one: node 4 hangs in the middle of its upper edge, node 1 goes.
TEST(AuditBoundary, FindsAHangingNode) {
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
  expect_defect(audit_edges, mesh, {"edge from node 2 at (0, -1) to node 3 at (1, -1)", "1 cell", "hanging node"});
}

TEST(AuditBoundary, FindsAnEdgeInNoPartOfTheBoundary) {
  Mesh mesh = block();
  mesh.edges.erase(mesh.edges.begin() + 5);
  expect_defect(audit_edges, mesh, {"edge from node 2 at (2, -2) to node 5 at (2, -1)", "no part of the boundary"});
}

TEST(AuditBoundary, FindsAnEdgeInTwoParts) {
  Mesh mesh = block();
  mesh.edges.push_back({{8, 7}, Boundary::contact});
  expect_defect(audit_edges, mesh,
                {"contact edge 8 from node 8 at (2, 0) to node 7 at (1, 0)", "free edge 3", "one part"});
}

TEST(AuditBoundary, FindsABoundaryEdgeInsideTheBody) {
  Mesh mesh = block();
  mesh.edges.push_back({{4, 5}, Boundary::far});
  expect_defect(audit_edges, mesh, {"far edge 8 from node 4", "belongs to 2 cells", "must be 1"});
  mesh.edges.back().nodes = {0, 8};
  expect_defect(audit_edges, mesh, {"far edge 8 from node 0", "belongs to 0 cells", "must be 1"});
}

TEST(AuditBoundary, FindsAnEdgeOfThreeCells) {
  Mesh mesh = block();
  mesh.nodes.push_back({1.2, -0.4});
  mesh.nodes.push_back({1.8, -0.4});
  mesh.cells.push_back({4, 5, 10, 9});
  expect_defect(audit_edges, mesh, {"edge from node 4 at (1, -1) to node 5 at (2, -1)", "3 cells", "at most 2"});
}

TEST(AuditBoundary, FindsAMissingPartOfTheBoundary) {
  for (const Boundary missing : needed_boundaries) {
    Mesh mesh = block();
    for (auto& edge : mesh.edges)
      if (edge.boundary == missing) edge.boundary = Boundary::far;
    expect_defect(audit_parts_of_boundary, mesh, {boundary_name(missing) + " has 0 edges", "at least 1"});
  }
}

TEST(AuditBoundary, WantsAFarBoundaryOrABase) {
  Mesh mesh = block();
  for (auto& edge : mesh.edges)
    if (edge.boundary == Boundary::far) edge.boundary = Boundary::base;
  EXPECT_NO_THROW(audit_parts_of_boundary(mesh, "block"));
  for (auto& edge : mesh.edges)
    if (edge.boundary == Boundary::base) edge.boundary = Boundary::free;
  expect_defect(audit_parts_of_boundary, mesh, {"far and base have 0 edges", "at least 1"});
}

TEST(AuditBoundary, FindsAnAxisOffTheAxis) {
  Mesh mesh = block();
  mesh.nodes[3][0] = 1e-15;
  expect_defect(audit_parts_of_boundary, mesh, {"axis edge 0", "node 3 at (1e-15, -1)", "r = 1e-15", "r = 0 exactly"});
}

TEST(AuditBoundary, FindsAnEdgeOnTheAxisThatIsNotAxis) {
  Mesh mesh = block();
  mesh.edges[0].boundary = Boundary::far;
  expect_defect(audit_parts_of_boundary, mesh,
                {"far edge 0 from node 0 at (0, -2) to node 3 at (0, -1)", "r = 0", "must be axis"});
}

TEST(AuditBoundary, FindsAContactLineOffTheSurface) {
  Mesh mesh = block();
  mesh.nodes[7][1] = -0.1;
  expect_defect(audit_contact_line, mesh, {"contact edge 2", "node 7 at (1, -0.1)", "z = -0.1", "z = 0 exactly"});
}

TEST(AuditBoundary, FindsAContactLineWithGaps) {
  Mesh mesh = block();
  std::swap(mesh.edges[2].boundary, mesh.edges[3].boundary);
  expect_defect(audit_contact_line, mesh, {"contact line", "from r = 0 to 1", "without gaps"});
}

TEST(AuditBoundary, FindsABodyInTwoParts) {
  Mesh mesh = block();
  for (const auto& node : {std::array<double, 2>{5, -2}, {6, -2}, {6, -1}, {5, -1}}) mesh.nodes.push_back(node);
  mesh.cells.push_back({9, 10, 11, 12});
  for (unsigned i = 0; i < 4; ++i) mesh.edges.push_back({{9 + i, 9 + (i + 1) % 4}, Boundary::far});
  expect_defect(audit_body, mesh, {"walk around the boundary", "8 of its 12 edges", "one part without holes"});
}

TEST(AuditBoundary, FindsPartsThatTouchInOneNode) {
  Mesh mesh = block();
  for (const auto& node : {std::array<double, 2>{3, -3}, {4, -3}, {4, -2}}) mesh.nodes.push_back(node);
  mesh.cells.push_back({2, 9, 10, 11});
  mesh.edges.push_back({{2, 9}, Boundary::far});
  mesh.edges.push_back({{9, 10}, Boundary::far});
  mesh.edges.push_back({{10, 11}, Boundary::far});
  mesh.edges.push_back({{11, 2}, Boundary::far});
  expect_defect(audit_body, mesh, {"node 2 at (2, -2)", "on 4 edges of the boundary", "0 or 2"});
}

// A fifth cell on the right edge of cell 3, folded back over it instead of to the outside.
TEST(AuditBoundary, FindsOverlappingCells) {
  Mesh mesh = block();
  mesh.nodes.push_back({1.2, -0.1});
  mesh.nodes.push_back({1.2, -0.9});
  mesh.cells.push_back({8, 9, 10, 5});
  mesh.edges[4] = {{8, 9}, Boundary::far};
  mesh.edges.push_back({{9, 10}, Boundary::far});
  mesh.edges.push_back({{10, 5}, Boundary::far});
  expect_defect(audit_body, mesh, {"cells have an area of 4.72", "3.28", "overlap"});
}

// Four edges of length 1, the third of which is missing, in any order and sense.
TEST(AuditBoundary, FindsAGapInTheMiddleOfTheContactLine) {
  Mesh mesh{{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, {}, {}};
  for (const auto& nodes : {std::array<unsigned, 2>{4, 3}, {1, 0}, {1, 2}})
    mesh.edges.push_back({nodes, Boundary::contact});
  expect_defect(audit_contact_line, mesh, {"no edge from r = 2 to 3", "without gaps"});
  mesh.edges.push_back({{3, 2}, Boundary::contact});
  EXPECT_NO_THROW(audit_contact_line(mesh, "block.msh"));
}

// 3 x 3 cells without the one in the middle: 12 edges outside, 4 around the hole.
TEST(AuditBoundary, FindsAHole) {
  Mesh mesh;
  for (int i = 0; i < 16; ++i) mesh.nodes.push_back({double(i % 4), i / 4 - 3.});
  for (const unsigned first : {0U, 1U, 2U, 4U, 6U, 8U, 9U, 10U})
    mesh.cells.push_back({first, first + 1, first + 5, first + 4});
  for (const auto& nodes : {std::array<unsigned, 2>{0, 1},
                            {1, 2},
                            {2, 3},
                            {3, 7},
                            {7, 11},
                            {11, 15},
                            {15, 14},
                            {14, 13},
                            {13, 12},
                            {12, 8},
                            {8, 4},
                            {4, 0},
                            {5, 6},
                            {6, 10},
                            {10, 9},
                            {9, 5}})
    mesh.edges.push_back({nodes, Boundary::far});
  EXPECT_NO_THROW(audit_edges(mesh, "block.msh"));
  expect_defect(audit_body, mesh, {"12 of its 16 edges", "without holes"});
}

}  // namespace
}  // namespace fretval::meshes::audit_boundary_test
