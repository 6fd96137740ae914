#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fretval::source_tree_test {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// A room, by its folder, and the rooms that its files may include; every room may include itself.
using House = std::map<std::string, Names>;

/// The plan of docs/architecture.md. Rooms are listed from the ground up; `below` are all of a house listed before.
House plan() {
  House house;
  const auto floors = [&](const std::vector<std::vector<std::string>>& stack, const Names& outside) {
    Names below = outside;
    for (const auto& floor : stack) {
      for (const auto& room : floor) house[room] = below;
      below.insert(floor.begin(), floor.end());
    }
  };
  floors({{"mdr/support"},
          {"mdr/profiles"},
          {"mdr/motion"},
          {"mdr/rheology"},
          {"mdr/stick"},
          {"mdr/springs"},
          {"mdr/layer", "mdr/plane", "mdr/wear"}},
         {});
  floors({{"fem/support"},
          {"fem/operators"},
          {"fem/condensation"},
          {"fem/motion"},
          {"fem/contact"},
          {"fem/ring_contact"},
          {"fem/history"},
          {"fem/ring_contact/stick_zone", "fem/full_model"},
          {"fem/full_contact"},
          {"fem/wear"}},
         {"deal.II", "petsc"});
  floors({{"meshes"}}, {"gmsh"});
  Names libraries{"deal.II", "petsc", "gmsh"};
  for (const auto& [room, below] : house) libraries.insert(room);
  floors({{"comparison/support"},
          {"comparison/case", "comparison/quantities"},
          {"comparison/data"},
          {"comparison/case_file", "comparison/scene"},
          {"comparison/reference"},
          {"comparison/simulation/fem_case"},
          {"comparison/simulation/bodies"},
          {"comparison/simulation"},
          {"comparison/accuracy", "comparison/model_error"},
          {"comparison/results"},
          {"comparison/run"},
          {"comparison/trust", "comparison/verification"},
          {"comparison/verification/exact", "comparison/verification/trade"}},
         libraries);
  // Finite elements never learn what MDR makes of a case, but for what comparison/scene/from_mdr.h names.
  for (const char* room : {"comparison/simulation/fem_case", "comparison/simulation/bodies", "comparison/simulation"})
    for (const char* of_mdr :
         {"comparison/reference", "mdr/stick", "mdr/springs", "mdr/layer", "mdr/plane", "mdr/wear"})
      house[room].erase(of_mdr);
  floors({{"comparison/report/text"},
          {"comparison/report/drawing"},
          {"comparison/report/sections"},
          {"comparison/report"},
          {"comparison/command_line"}},
         [&] {
           Names below = libraries;
           for (const auto& [room, unused] : house) below.insert(room);
           return below;
         }());
  return house;
}

/// What an #include line includes; empty for any other line.
std::string included_file(const std::string& line) {
  const auto hash = line.find_first_not_of(" \t");
  const auto open = line.find_first_of("<\"");
  if (hash == std::string::npos || line[hash] != '#' || open == std::string::npos) return "";
  if (line.find("include", hash) > open) return "";
  const auto close = line.find_first_of(">\"", open + 1);
  return close == std::string::npos ? "" : line.substr(open + 1, close - open - 1);
}

/// The room that an included file belongs to; empty: a library that everybody may use.
std::string room_of(const std::string& file) {
  for (const char* library : {"deal.II", "petsc", "gmsh"})
    if (file.rfind(library, 0) == 0) return library;
  for (const char* top : {"mdr/", "meshes/", "fem/", "comparison/"})
    if (file.rfind(top, 0) == 0) return fs::path(file).parent_path().string();
  return "";
}

struct Include {
  std::string file, included;
};

std::vector<Include> includes_below(const fs::path& root, const std::string& top) {
  std::vector<Include> found;
  for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cc") continue;
    std::ifstream stream(entry.path());
    for (std::string line; std::getline(stream, line);)
      if (const auto included = included_file(line); !included.empty())
        found.push_back({entry.path().lexically_relative(root).string(), included});
  }
  return found;
}

std::vector<Include> all_includes() {
  std::vector<Include> all;
  for (const char* top : {"mdr", "meshes", "fem", "comparison"})
    for (auto& include : includes_below(FRETVAL_SOURCE_DIR, top)) all.push_back(std::move(include));
  return all;
}

/// Lines "file: include" that run against a plan.
std::vector<std::string> against(const House& house, const std::vector<Include>& includes) {
  std::vector<std::string> found;
  for (const auto& [file, included] : includes) {
    const std::string from = room_of(file), to = room_of(included);
    if (to.empty() || to == from) continue;
    const auto room = house.find(from);
    if (room == house.end() || room->second.count(to) == 0) found.push_back(file + ": " + included);
  }
  return found;
}

TEST(SourceTree, IncludesPointDownTheHouse) {
  EXPECT_EQ(against(plan(), all_includes()), std::vector<std::string>{});
}

TEST(SourceTree, TheCheckSeesAnIncludeThatRunsUp) {
  EXPECT_EQ(against(plan(), {{"fem/operators/grid.h", "fem/motion/motion.h"}}).size(), 1U);
  EXPECT_EQ(against(plan(), {{"mdr/stick/a.cc", "fem/motion/motion.h"}}).size(), 1U);
  EXPECT_EQ(against(plan(), {{"fem/motion/motion.cc", "mdr/motion/motion.h"}}).size(), 1U);
  EXPECT_EQ(against(plan(), {{"comparison/new_room/a.h", "comparison/support/files.h"}}).size(), 1U);
  EXPECT_EQ(against(plan(), {{"comparison/simulation/a.h", "comparison/reference/mdr_case.h"}}).size(), 1U);
  EXPECT_EQ(against(plan(), {{"fem/history/a.cc", "fem/operators/b.h"}, {"mdr/wear/a.h", "vector"}}).size(), 0U);
}

/// Files that include each other, by their own names.
std::vector<std::string> circles(const std::vector<Include>& includes) {
  std::map<std::string, Names> graph;  // a header and its source are one
  const auto name = [](const std::string& file) { return fs::path(file).replace_extension().string(); };
  for (const auto& [file, included] : includes)
    if (!room_of(included).empty() && name(file) != name(included)) graph[name(file)].insert(name(included));
  std::vector<std::string> found;
  for (const auto& [start, unused] : graph) {
    Names seen;
    std::vector<std::string> open{start};
    while (!open.empty()) {
      const auto here = open.back();
      open.pop_back();
      for (const auto& next : graph[here])
        if (seen.insert(next).second) open.push_back(next);
    }
    if (seen.count(start) > 0) found.push_back(start);
  }
  return found;
}

TEST(SourceTree, NoFilesIncludeEachOther) {
  EXPECT_EQ(circles(all_includes()), std::vector<std::string>{});
  EXPECT_EQ(circles({{"fem/a/x.h", "fem/a/y.h"}, {"fem/a/y.cc", "fem/a/x.h"}}).size(), 2U);
}

// What is kept of a computation is kept under a hash of the sources that made it: of all rooms of the finite elements
// but the full model, of which nothing is kept.
TEST(SourceTree, HashesOfWhatIsKeptKnowAllRoomsOfTheFiniteElements) {
  const fs::path root = FRETVAL_SOURCE_DIR;
  std::ifstream stream(root / "comparison/CMakeLists.txt");
  std::stringstream lists;
  lists << stream.rdbuf();
  Names rooms;
  for (const auto& entry : fs::recursive_directory_iterator(root / "fem"))
    if (entry.path().extension() == ".cc") rooms.insert(fs::relative(entry.path().parent_path(), root).string());
  EXPECT_EQ(rooms.erase("fem/full_model"), 1U);
  EXPECT_GT(rooms.size(), 5U);
  for (const auto& room : rooms) EXPECT_NE(lists.str().find("${root}/" + room + "/*"), std::string::npos) << room;
}

}  // namespace
}  // namespace fretval::source_tree_test
