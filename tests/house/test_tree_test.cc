#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace fretval::test_tree_test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// Sources without a test file of their own, by how their names begin, and why.
const std::map<std::string, std::string> exceptions{
    {"comparison/command_line/commands", "the tests of the program run it"},
    {"comparison/command_line/main", "the tests of the program run it"},
    {"comparison/command_line/mdr_command", "the tests of the program run it"},
    {"comparison/command_line/run_command", "the tests of the program run it"},
    {"comparison/support/log", "hands messages to a library; the tests of the program read them"},
    {"comparison/verification/exact/exact_rows", "the list of all rows, counted by the test of the command check"}};

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

bool begins_with(const std::string& source, const std::string& start) {
  return source.rfind(start, 0) == 0;
}

/// Sources that have neither tests nor a reason for having none.
std::vector<std::string> forgotten(const Names& sources, const Names& tests) {
  std::vector<std::string> found;
  for (const auto& source : sources) {
    bool excused = false;
    for (const auto& [start, reason] : exceptions) excused = excused || begins_with(source, start);
    if (!excused && !is_tested(source, tests)) found.push_back(source);
  }
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

TEST(TestTree, NoExceptionIsLeftOver) {
  const Names tests = all_tests();
  for (const auto& [start, reason] : exceptions) {
    int n_untested = 0;
    for (const auto& source : all_sources()) n_untested += begins_with(source, start) && !is_tested(source, tests);
    EXPECT_GT(n_untested, 0) << start;
  }
}

}  // namespace
}  // namespace fretval::test_tree_test
