#include "meshes/audit.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/meshes/expect_defect.h"

namespace fretval::meshes::audit_test {
namespace {

TEST(Audit, PassesAGoodMesh) {
  EXPECT_NO_THROW(audit(block(), "block.msh"));
}

// One defect for each step, put in from the last step to the first: the audit always names the one that goes before.
TEST(Audit, TakesAllItsStepsInTheirOrder) {
  Mesh mesh = block();
  for (const auto& node : {std::array<double, 2>{5, -2}, {6, -2}, {6, -1}, {5, -1}}) mesh.nodes.push_back(node);
  mesh.cells.push_back({9, 10, 11, 12});
  for (unsigned i = 0; i < 4; ++i) mesh.edges.push_back({{9 + i, 9 + (i + 1) % 4}, Boundary::far});
  expect_defect(audit, mesh, {"walk around the boundary"});
  std::swap(mesh.edges[2].boundary, mesh.edges[3].boundary);
  expect_defect(audit, mesh, {"contact line"});
  mesh.edges[0].boundary = Boundary::far;
  expect_defect(audit, mesh, {"must be axis"});
  mesh.edges.pop_back();
  expect_defect(audit, mesh, {"no part of the boundary"});
  mesh.nodes.push_back({0.3, -0.3});
  expect_defect(audit, mesh, {"used by 0 cells"});
  mesh.cells.push_back(mesh.cells[0]);
  expect_defect(audit, mesh, {"must have its own"});
  mesh.nodes[8][1] = 0.25;
  expect_defect(audit, mesh, {"at most 0"});
  mesh.cells[0][0] = 99;
  expect_defect(audit, mesh, {"below the number of nodes"});
}

}  // namespace
}  // namespace fretval::meshes::audit_test
