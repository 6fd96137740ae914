#include "comparison/support/files.h"

#include <gtest/gtest.h>

#include <iterator>

#include "tests/comparison/run_fretval.h"

namespace fretval {
namespace {

TEST(WriteFile, ReplacesAFileAndLeavesNothingBesideIt) {
  const ScratchFolder folder;
  const auto file = folder.write("a.txt", "an old and longer text");
  write_file(file, std::string("new\0text", 8));
  EXPECT_EQ(text_of(file), std::string("new\0text", 8));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(WriteFile, NamesAFileThatCannotBeWrittenAndKeepsTheOldOne) {
  const ScratchFolder folder;
  const auto file = folder.path() / "nowhere" / "a.txt";
  try {
    write_file(file, "text");
    FAIL();
  } catch (const std::filesystem::filesystem_error& error) {
    EXPECT_EQ(error.path1(), file);
  }
  const auto old = folder.write("old.txt", "old");
  std::filesystem::create_directory(old.string() + ".partial");
  EXPECT_THROW(write_file(old, "new"), std::filesystem::filesystem_error);
  EXPECT_EQ(text_of(old), "old");
}

TEST(ContentOf, IsEveryByteOrNothing) {
  const ScratchFolder folder;
  const std::string bytes("\r\n\0\xff", 4);
  write_file(folder.path() / "a.bin", bytes);
  EXPECT_EQ(content_of(folder.path() / "a.bin"), bytes);
  EXPECT_EQ(content_of(folder.path() / "nowhere"), "");
  EXPECT_EQ(content_of(folder.path()), "");
}

TEST(WriteCsv, HasANamedColumnEachAndTenDigits) {
  const ScratchFolder folder;
  const auto file = folder.path() / "a.csv";
  write_csv(file, {{"r [m]", Eigen::Vector2d(1.0 / 3, 1e-9)}, {"p [Pa]", Eigen::Vector2d(-2, 12345678901.0)}});
  EXPECT_EQ(text_of(file), "r [m],p [Pa]\n0.3333333333,-2\n1e-09,1.23456789e+10\n");
}

}  // namespace
}  // namespace fretval
