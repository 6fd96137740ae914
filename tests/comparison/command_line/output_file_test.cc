#include "comparison/command_line/output_file.h"

#include <gtest/gtest.h>

#include "tests/comparison/expect_parts.h"
#include "tests/comparison/refusal.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {
namespace {

TEST(OutputFile, HasAFolderToLieInAndIsNone) {
  const ScratchFolder folder;
  const auto file = folder.path() / "new" / "map.csv";
  prepare_output_file("--map", file.string());
  EXPECT_TRUE(std::filesystem::is_directory(file.parent_path()));
  EXPECT_FALSE(std::filesystem::exists(file));
  prepare_output_file("--map", "");
  prepare_output_file("--map", "map.csv");
  expect_parts(refusal([&] { prepare_output_file("--map", folder.path().string()); }),
               {"is a folder", "--map expects"});
}

}  // namespace
}  // namespace fretval
