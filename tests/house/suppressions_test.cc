#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

// Exceptions of tests/static/run cppcheck that are made for one file follow it when it moves: or else they are made for
// none.
namespace fretval::suppressions_test {
namespace {

namespace fs = std::filesystem;

/// Files that a list of suppressions names, "check:file" a line.
std::vector<std::string> files_in(std::istream& stream) {
  std::vector<std::string> files;
  for (std::string line; std::getline(stream, line);)
    if (const auto colon = line.find(':'); line[0] != '#' && colon != std::string::npos)
      files.push_back(line.substr(colon + 1));
  return files;
}

TEST(Suppressions, AreMadeForFilesThatAreThere) {
  std::ifstream stream(fs::path(FRETVAL_SOURCE_DIR) / "tests/static/cppcheck.supp");
  const auto files = files_in(stream);
  EXPECT_GT(files.size(), 5U);
  for (const auto& file : files) EXPECT_TRUE(fs::is_regular_file(fs::path(FRETVAL_SOURCE_DIR) / file)) << file;
}

TEST(Suppressions, TheCheckReadsTheirFiles) {
  std::istringstream list("# False: a lambda writes.\neverywhere\n\nconstParameter:a/b.cc\n");
  EXPECT_EQ(files_in(list), std::vector<std::string>{"a/b.cc"});
}

}  // namespace
}  // namespace fretval::suppressions_test
