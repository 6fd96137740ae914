#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace fretval::test_tree_test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// All .cc below a folder, from it on and without the extension.
Names sources_below(const fs::path& root, const std::string& top) {
  Names found;
  for (const auto& entry : fs::recursive_directory_iterator(root / top))
    if (entry.path().extension() == ".cc")
      found.insert(entry.path().lexically_relative(root).replace_extension().string());
  return found;
}

Names all_sources() {
  Names all;
  for (const char* top : {"mdr", "meshes", "fem", "comparison"}) all.merge(sources_below(FRETVAL_SOURCE_DIR, top));
  return all;
}

Names all_tests() {
  return sources_below(fs::path(FRETVAL_SOURCE_DIR), "tests");
}

bool is_tested(const std::string& source, const Names& tests) {
  return tests.count("tests/" + source + "_test") > 0;
}

/// Sources that have no tests in the same place.
std::vector<std::string> forgotten(const Names& sources, const Names& tests) {
  std::vector<std::string> found;
  for (const auto& source : sources)
    if (!is_tested(source, tests)) found.push_back(source);
  return found;
}

TEST(TestTree, EverySourceHasItsTestsInTheSamePlace) {
  EXPECT_EQ(forgotten(all_sources(), all_tests()), std::vector<std::string>{});
  EXPECT_GT(all_sources().size(), 100U);
}

TEST(TestTree, TheCheckSeesTestsThatAreMissingOrElsewhere) {
  const Names tests{"tests/mdr/stick/a_test", "tests/fem/b_test"};
  EXPECT_EQ(forgotten({"mdr/stick/a", "mdr/wear/a", "fem/history/b"}, tests),
            (std::vector<std::string>{"fem/history/b", "mdr/wear/a"}));
}

}  // namespace
}  // namespace fretval::test_tree_test
