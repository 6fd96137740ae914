#include "comparison/support/folders.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/variable.h"

namespace fretval::folders_test {
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

TEST(CacheFolder, IsThatOfXdgOrInTheHomeOfTheUser) {
  const Variable cache("XDG_CACHE_HOME", "/somewhere/cache"), home("HOME", "/home/somebody");
  EXPECT_EQ(cache_folder(), "/somewhere/cache/fretval");
  for (const char* not_set : {"", "not/absolute"}) {
    const Variable other("XDG_CACHE_HOME", not_set);
    EXPECT_EQ(cache_folder(), "/home/somebody/.cache/fretval");
    const Variable homeless("HOME", not_set);
    EXPECT_EQ(cache_folder(), std::nullopt);
  }
}

TEST(FolderLock, MakesAFolderAndHasItAloneAsLongAsItLives) {
  const ScratchFolder folder;
  const auto place = folder.path() / "new" / "place";
  {
    const FolderLock lock(place);
    try {
      const FolderLock second(place);
      FAIL();
    } catch (const std::filesystem::filesystem_error& error) {
      expect_parts(error.what(), {"another fretval is writing", place.string()});
    }
    EXPECT_NO_THROW(FolderLock(folder.path() / "other"));
  }
  EXPECT_NO_THROW(FolderLock{place});
  EXPECT_TRUE(std::filesystem::is_empty(place));
}

TEST(FolderLock, NeedsAFolder) {
  const ScratchFolder folder;
  const auto file = folder.write("file", "");
  EXPECT_THROW(FolderLock{file}, std::filesystem::filesystem_error);
}

}  // namespace
}  // namespace fretval::folders_test
