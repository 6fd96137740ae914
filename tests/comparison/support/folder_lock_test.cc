#include "comparison/support/folder_lock.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

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
}  // namespace fretval
