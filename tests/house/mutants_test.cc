#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

// The list of tests/mutants/run fits the sources: or else nobody would know before the next night.
namespace fretval::mutants_test {
namespace {

namespace fs = std::filesystem;

/// Lines of a mutant by their first word.
using Mutant = std::map<std::string, std::string>;

std::vector<Mutant> mutants_in(std::istream& stream) {
  std::vector<Mutant> mutants{{}};
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() && !mutants.back().empty()) mutants.emplace_back();
    if (line.empty() || line[0] == '#') continue;
    const auto blank = std::min(line.find(' '), line.size() - 1);
    mutants.back()[line.substr(0, blank)] = line.substr(blank + 1);
  }
  if (mutants.back().empty()) mutants.pop_back();
  return mutants;
}

std::vector<Mutant> all_mutants() {
  std::ifstream stream(fs::path(FRETVAL_SOURCE_DIR) / "tests/mutants/mutants.txt");
  return mutants_in(stream);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// What is wrong with a mutant of a text; empty: it applies.
std::string defect(const Mutant& mutant, const std::string& text) {
  for (const char* key : {"mutant", "file", "-", "+"})
    if (mutant.count(key) == 0) return std::string("has no ") + key;
  if (mutant.at("-") == mutant.at("+")) return "changes nothing";
  const auto n = count(text, mutant.at("-"));
  return n == 1 ? "" : "stands there " + std::to_string(n) + " times: " + mutant.at("-");
}

TEST(Mutants, AllApply) {
  std::set<std::string> names;
  for (const auto& mutant : all_mutants()) {
    const auto file = mutant.count("file") > 0 ? mutant.at("file") : "";
    std::ifstream stream(fs::path(FRETVAL_SOURCE_DIR) / file);
    std::stringstream text;
    text << stream.rdbuf();
    const auto name = mutant.count("mutant") > 0 ? mutant.at("mutant") : "";
    EXPECT_EQ(defect(mutant, text.str()), "") << name << " in " << file;
    EXPECT_TRUE(names.insert(name).second) << name << " is there twice";
  }
}

/// Names of the tests in a text as GoogleTest has them, those with a parameter by the first of each instantiation.
std::set<std::string> tests_in(const std::string& text) {
  const auto all = [&](const std::string& pattern) {
    const std::regex regex(pattern);
    return std::vector<std::smatch>(std::sregex_iterator(text.begin(), text.end(), regex), {});
  };
  std::set<std::string> tests;
  for (const auto& match : all(R"(\nTEST(?:_F)?\(\s*(\w+),\s*(\w+)\))"))
    tests.insert(match.str(1) + "." + match.str(2));
  for (const auto& match : all(R"(\nTEST_P\(\s*(\w+),\s*(\w+)\))"))
    for (const auto& instance : all(R"(\nINSTANTIATE_TEST_SUITE_P\(\s*(\w+),\s*)" + match.str(1) + ","))
      tests.insert(instance.str(1) + "/" + match.str(1) + "." + match.str(2) + "/0");
  return tests;
}

std::set<std::string> tests_of_folder(const std::string& folder) {
  std::set<std::string> tests;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(FRETVAL_SOURCE_DIR) / "tests" / folder)) {
    if (entry.path().extension() != ".cc") continue;
    std::ifstream stream(entry.path());
    std::stringstream text;
    text << '\n' << stream.rdbuf();
    tests.merge(tests_in(text.str()));
  }
  return tests;
}

/// Patterns of a filter of GoogleTest that no test has.
std::vector<std::string> without_a_test(const std::string& filter, const std::set<std::string>& tests) {
  std::vector<std::string> found;
  std::istringstream stream(filter);
  for (std::string pattern; std::getline(stream, pattern, ':');)
    if (std::none_of(tests.begin(), tests.end(),
                     [&](const std::string& test) { return fnmatch(pattern.c_str(), test.c_str(), 0) == 0; }))
      found.push_back(pattern);
  return found;
}

TEST(Mutants, NameTestsThatAreThere) {
  std::map<std::string, std::set<std::string>> tests;
  for (const auto& mutant : all_mutants()) {
    if (mutant.count("tests") == 0) continue;
    const auto folder = fs::path(mutant.at("file")).begin()->string();
    if (tests.count(folder) == 0) tests[folder] = tests_of_folder(folder);
    for (const auto& pattern : without_a_test(mutant.at("tests"), tests[folder]))
      ADD_FAILURE() << mutant.at("mutant") << ": no test of " << folder << " is called " << pattern;
  }
}

TEST(Mutants, TheCheckSeesNamesOfNoTest) {
  const auto tests = tests_in("\nTEST(A, One) {}\nTEST_P(B, Two) {}\nINSTANTIATE_TEST_SUITE_P(Of, B, Values(1));\n");
  EXPECT_EQ(tests, (std::set<std::string>{"A.One", "Of/B.Two/0"}));
  EXPECT_EQ(without_a_test("A.*:A:Of/B.*:B*:*Two*", tests), (std::vector<std::string>{"A", "B*"}));
}

TEST(Mutants, AreManyInEveryFolder) {
  std::map<std::string, int> n;
  for (const auto& mutant : all_mutants())
    n[fs::path(mutant.at("file")).begin()->string()] += mutant.count("equivalent") == 0;
  EXPECT_GE(n["comparison"], 40);
  EXPECT_GE(n["fem"], 20);
  EXPECT_GE(n["mdr"], 15);
  EXPECT_GE(n["meshes"], 10);
}

TEST(Mutants, TheCheckSeesWhatDoesNotApply) {
  std::istringstream list("# a comment\nmutant a\nfile f.cc\n- x + y\n+ x - y\n\n\nmutant b\nfile f.cc\n- z\n+ z\n");
  const auto mutants = mutants_in(list);
  ASSERT_EQ(mutants.size(), 2U);
  EXPECT_EQ(defect(mutants[0], "return x + y;"), "");
  EXPECT_NE(defect(mutants[0], "return x * y;"), "");
  EXPECT_NE(defect(mutants[0], "return x + y > x + y;"), "");
  EXPECT_NE(defect(mutants[1], "z"), "");
  EXPECT_NE(defect({{"mutant", "a"}}, "z"), "");
}

}  // namespace
}  // namespace fretval::mutants_test
