#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "meshes/audit.h"
#include "meshes/grading.h"
#include "meshes/msh_file.h"
#include "meshes/quarter_disc.h"

namespace fretval::meshes::small_meshes_test {
namespace {

/// The committed meshes, as meshes/small/README.md says they were made.
struct SmallMesh {
  std::string file;
  unsigned n_contact_elements;
};

class SmallMeshes : public testing::TestWithParam<SmallMesh> {
 protected:
  std::filesystem::path file = std::filesystem::path(SMALL_MESHES) / GetParam().file;
  Mesh stored = read_msh(file);
  Mesh regenerated = quarter_disc({uniform_nodes(1.2, GetParam().n_contact_elements), 25.});
};

TEST_P(SmallMeshes, PassTheAudit) {
  EXPECT_NO_THROW(audit(stored, file.string()));
}

TEST_P(SmallMeshes, AreSmall) {
  EXPECT_LT(std::filesystem::file_size(file), 400000U);
}

// Another build of gmsh may place inner nodes elsewhere; what the recipe fixes must be the same.
TEST_P(SmallMeshes, FollowTheRecipe) {
  const auto radii = contact_radii(stored);
  const auto wanted = contact_radii(regenerated);
  ASSERT_EQ(radii.size(), GetParam().n_contact_elements + 1);
  ASSERT_EQ(wanted.size(), radii.size());
  for (std::size_t i = 0; i < radii.size(); ++i) EXPECT_NEAR(radii[i], wanted[i], 1e-15);
  // Far edges are chords of about 3.3 in a circle of 25: one more or less of them changes length and area by less.
  EXPECT_NEAR(quality(stored).area, quality(regenerated).area, 1e-3 * quality(stored).area);
  for (const Boundary boundary : all_boundaries) {
    const double length = boundary_length(stored, boundary);
    EXPECT_NEAR(length, boundary_length(regenerated, boundary), (boundary == Boundary::far ? 1e-3 : 1e-14) * length);
  }
  const auto n_cells = static_cast<double>(stored.cells.size());
  EXPECT_NEAR(static_cast<double>(regenerated.cells.size()), n_cells, 0.1 * n_cells);
}

TEST_P(SmallMeshes, HaveGoodCells) {
  EXPECT_GT(quality(stored).min_scaled_jacobian, 0.5);
  EXPECT_GT(quality(stored).mean_scaled_jacobian, 0.9);
}

INSTANTIATE_TEST_SUITE_P(Committed, SmallMeshes,
                         testing::Values(SmallMesh{"coarse.msh", 24}, SmallMesh{"fine.msh", 48}),
                         [](const auto& info) { return std::filesystem::path(info.param.file).stem().string(); });

}  // namespace
}  // namespace fretval::meshes::small_meshes_test
