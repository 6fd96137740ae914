#include "comparison/verification/extremes/flat_mesh.h"

#include <gtest/gtest.h>

#include "meshes/audit.h"
#include "tests/comparison/small_body.h"

namespace fretval {
namespace {

TEST(FlatMesh, HasFlatCellsAndTheOldBoundary) {
  const auto mesh = mesh_of(small_body());
  const auto flat = flattened(mesh, 100, 0.25, 1);
  meshes::audit(flat, "flat");
  EXPECT_GT(meshes::quality(flat).max_aspect_ratio, 90);
  EXPECT_LT(meshes::quality(mesh).max_aspect_ratio, 20);
  EXPECT_NEAR(meshes::quality(flat).area, meshes::quality(mesh).area, 1e-6);
}

}  // namespace
}  // namespace fretval
