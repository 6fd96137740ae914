#include "comparison/support/data_folder.h"

#include <gtest/gtest.h>

#include "tests/comparison/scratch_folder.h"

namespace fretval::data_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(DataFolder, LiesBesideAnInstalledProgramOrIsTheSourceTree) {
  const ScratchFolder folder;
  fs::create_directories(folder.path() / "bin");
  EXPECT_EQ(data_folder_beside(folder.path() / "bin"), FRETVAL_SOURCE_DIR);
  fs::create_directories(folder.path() / "share/fretval/meshes/small");
  EXPECT_EQ(data_folder_beside(folder.path() / "bin"), folder.path() / "share/fretval");
}

TEST(DataFolder, HoldsTheMeshesAndCasesOfTheChecks) {
  for (const char* file : {"meshes/small/coarse.msh", "meshes/small/fine.msh", "cases/extremes/flat-face.csv",
                           "cases/check/parabola-standard-solid.prm"})
    EXPECT_TRUE(fs::exists(data_folder() / file)) << file;
}

}  // namespace
}  // namespace fretval::data_folder_test
