#include "meshes/msh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "meshes/audit.h"
#include "meshes/grading.h"
#include "meshes/quarter_disc.h"
#include "tests/meshes/block.h"
#include "tests/meshes/expect_error.h"
#include "tests/meshes/scratch_folder.h"

namespace fretval::meshes::msh_file_test {
namespace {

class MshFile : public testing::Test {
 protected:
  /// Writes the text to a file, and expects an error with the file's name and the given parts when it is read.
  void expect_unreadable(const std::string& text, std::vector<std::string> parts) {
    write_text(file, text);
    parts.push_back(file.string());
    expect_error([this] { read_msh(file); }, parts);
  }

  std::string block_text() {
    write_msh(block(), file);
    return read_text(file);
  }

  ScratchFolder folder;
  std::filesystem::path file = folder / "mesh.msh";
};

void expect_same(const Mesh& a, const Mesh& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.cells, b.cells);
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].nodes, b.edges[i].nodes);
    EXPECT_EQ(a.edges[i].boundary, b.edges[i].boundary);
  }
}

TEST_F(MshFile, KeepsAllDigits) {
  const Mesh mesh = quarter_disc({graded_nodes({1e-3 / 3, 1e-3 / 3, 1e-7}, 1e-3, 1e-4 / 3, 0.2), 0.025});
  write_msh(mesh, file);
  expect_same(read_msh(file), mesh);
}

TEST_F(MshFile, ReplacesAFileAndLeavesNoOther) {
  write_text(file, "old");
  write_msh(block(), file);
  expect_same(read_msh(file), block());
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".partial"));
}

TEST_F(MshFile, IsASystemErrorIfItCannotBeWritten) {
  EXPECT_THROW(write_msh(block(), folder / "none" / "mesh.msh"), std::filesystem::filesystem_error);
  EXPECT_THROW(write_msh(block(), "/dev/full/mesh.msh"), std::filesystem::filesystem_error);
}

TEST_F(MshFile, MustExistAndHaveText) {
  expect_error([this] { read_msh(folder / "none.msh"); }, {"none.msh", "no such file"});
  std::filesystem::create_directory(folder / "folder.msh");
  expect_error([this] { read_msh(folder / "folder.msh"); }, {"folder.msh", "cannot be opened"});
  expect_unreadable("", {"0 characters"});
  expect_unreadable(" \n", {"2 characters"});
  expect_unreadable("solid cube", {"line 1", "solid", "must be $MeshFormat"});
}

TEST_F(MshFile, MustNotBeTruncatedAnywhere) {
  const std::string text = block_text();
  // Without the newline and the last letter "$EndElement" is left.
  for (std::size_t length = 0; length < text.size() - 1; length += 7) {
    SCOPED_TRACE(length);
    expect_unreadable(text.substr(0, length), {"must"});
  }
  expect_unreadable(text.substr(0, text.find("$EndElements")), {"$EndElements", "missing", "ends too early"});
}

// Whatever is in the file: a mesh that passes the audit, or an error.
TEST_F(MshFile, MayHoldAnything) {
  std::mt19937 engine(1);
  const std::string text = block_text();
  for (int k = 0; k < 300; ++k) {
    std::string damaged = text;
    for (int n = 0; n <= k % 5; ++n) damaged[engine() % damaged.size()] = static_cast<char>(engine());
    write_text(file, damaged);
    try {
      audit(read_msh(file), file.string());
    } catch (const MeshError& error) {
      EXPECT_EQ(std::string(error.what()).rfind(file.string(), 0), 0U) << error.what();
    }
  }
}

TEST_F(MshFile, LeavesNotANumberToTheAudit) {
  write_text(file, replaced(block_text(), "5 1 -1 0", "5 nan -1 0"));
  expect_error([this] { audit(read_msh(file), file.string()); }, {"node 4", "nan", "finite"});
}

TEST_F(MshFile, MustBePlane) {
  expect_unreadable(replaced(block_text(), "5 1 -1 0", "5 1 -1 0.5"),
                    {"node 5 at (1, -1, 0.5)", "third coordinate 0.5", "must be 0"});
}

TEST_F(MshFile, MustHaveAllGroups) {
  const std::string text = block_text();
  expect_unreadable(replaced(text, "3 1 2 2 2 7 8", "3 1 2 3 3 7 8"),
                    {"physical group \"contact\" has no elements", "found axis, body, far, free", "must have all of"});
  expect_unreadable(text.substr(0, text.find("$Nodes")), {"\"body\" has no elements", "found none"});
}

TEST_F(MshFile, MustHaveKnownGroupsAlone) {
  const std::string text = block_text();
  expect_unreadable(replaced(text, "\"free\"", "\"loose\""), {"line element 4", "group 3 \"loose\"", "\"free\""});
  expect_unreadable(replaced(text, "3 1 2 2 2 7 8", "3 1 2 6 6 7 8"), {"line element 3", "group 6 \"\""});
  expect_unreadable(replaced(text, "9 3 2 10 10", "9 3 0"), {"quadrilateral element 9", "group 0 \"\"", "\"body\""});
}

TEST_F(MshFile, MayNumberGroupsAndNodesAsItLikes) {
  std::string text = replaced(block_text(), "1 2 \"contact\"", "1 77 \"contact\"");
  text = replaced(text, "3 1 2 2 2 7 8", "3 1 2 77 2 7 8");
  text = replaced(text, "$Nodes\n", "$Comments\nby hand\n$EndComments\n$Nodes\n");
  write_text(file, text);
  expect_same(read_msh(file), block());
}

TEST_F(MshFile, TurnsAClockwiseBodyButNotASingleCell) {
  Mesh mesh = block();
  std::reverse(mesh.cells[1].begin(), mesh.cells[1].end());
  write_msh(mesh, file);
  expect_error([this] { audit(read_msh(file), file.string()); }, {"cell 1", "inverted"});
  for (const std::size_t i : {0, 2, 3}) std::reverse(mesh.cells[i].begin(), mesh.cells[i].end());
  write_msh(mesh, file);
  EXPECT_NO_THROW(audit(read_msh(file), file.string()));
}

}  // namespace
}  // namespace fretval::meshes::msh_file_test
