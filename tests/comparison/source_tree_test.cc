#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace fretval {
namespace {

namespace fs = std::filesystem;

/// What an #include line includes; empty for any other line.
std::string included_file(const std::string& line) {
  const auto hash = line.find_first_not_of(" \t");
  const auto open = line.find_first_of("<\"");
  if (hash == std::string::npos || line[hash] != '#' || open == std::string::npos) return "";
  if (line.find("include", hash) > open) return "";
  const auto close = line.find_first_of(">\"", open + 1);
  return close == std::string::npos ? "" : line.substr(open + 1, close - open - 1);
}

/// Lines "file: include" of a source folder whose include begins with one of the forbidden prefixes.
std::vector<std::string> forbidden_includes(const fs::path& folder, const std::vector<std::string>& forbidden) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cc") continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);)
      for (const auto& prefix : forbidden)
        if (included_file(line).rfind(prefix, 0) == 0) found.push_back(entry.path().string() + ": " + line);
  }
  return found;
}

// The direction of knowledge: mdr, meshes and fem know nothing of each other, and only fem knows deal.II and PETSc.
TEST(SourceTree, IncludesPointOneWay) {
  const fs::path root(FRETVAL_SOURCE_DIR);
  const std::vector<std::string> none;
  EXPECT_EQ(forbidden_includes(root / "mdr", {"fem/", "meshes/", "comparison/", "deal.II/", "petsc", "gmsh"}), none);
  EXPECT_EQ(forbidden_includes(root / "meshes", {"fem/", "mdr/", "comparison/", "deal.II/", "petsc"}), none);
  EXPECT_EQ(forbidden_includes(root / "fem", {"mdr/", "meshes/", "comparison/", "gmsh"}), none);
}

TEST(SourceTree, TheCheckSeesAForbiddenInclude) {
  EXPECT_FALSE(forbidden_includes(fs::path(FRETVAL_SOURCE_DIR) / "comparison", {"fem/"}).empty());
}

}  // namespace
}  // namespace fretval
