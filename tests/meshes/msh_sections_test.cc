#include "meshes/msh_sections.h"

#include <gtest/gtest.h>

#include "meshes/msh_file.h"
#include "tests/meshes/block.h"
#include "tests/meshes/expect_error.h"
#include "tests/meshes/scratch_folder.h"

namespace fretval::meshes::msh_sections_test {
namespace {

class MshSectionsTest : public testing::Test {
 protected:
  MshSections read(const std::string& text) {
    write_text(file, text);
    return read_sections(file);
  }

  /// Expects an error with the file's name and the given parts.
  void expect_unreadable(const std::string& text, std::vector<std::string> parts) {
    parts.push_back(file.string() + ", line ");
    expect_error([&] { read(text); }, parts);
  }

  std::string block_text() {
    write_msh(block(), file);
    return read_text(file);
  }

  ScratchFolder folder;
  std::filesystem::path file = folder / "mesh.msh";
};

/// A unit square with one edge, in version 4.1: curve 1 and surface 1 are in different groups, the curve runs against
/// its own, and nodes on the curve have a parameter.
const char* const square_41 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "axis"
2 7 "body"
$EndPhysicalNames
$Entities
1 1 1 0
1 0 0 0 0
1 0 0 0 0 1 0 1 -7 2 1 -1
1 0 0 0 1 1 0 1 9 1 1
$EndEntities
$Nodes
2 4 10 40
1 1 1 2
40
10
0 1 0 0.5
0 0 0 1.5
2 1 0 2
20
30
1 0 0
1 1 0
$EndNodes
$Elements
3 3 1 3
0 1 15 1
1 40
1 1 1 1
2 40 10
2 1 3 1
3 10 20 30 40
$EndElements
)";

using Points = std::vector<std::array<double, 3>>;
using Nodes = std::vector<unsigned>;

TEST_F(MshSectionsTest, OfVersion41TakeGroupsFromEntitiesOfTheirDimension) {
  const MshSections sections = read(square_41);
  EXPECT_EQ(sections.group_names.at({1, 7}), "axis");
  EXPECT_EQ(sections.group_names.at({2, 7}), "body");
  EXPECT_EQ(sections.node_numbers, (std::vector<long long>{40, 10, 20, 30}));
  EXPECT_EQ(sections.nodes, (Points{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
  ASSERT_EQ(sections.elements.size(), 3U);
  const MshSections::Element wanted[] = {
      {1, msh_point, 0, {0}}, {2, msh_line, 7, {0, 1}}, {3, msh_quadrilateral, 9, {1, 2, 3, 0}}};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(sections.elements[i].number, wanted[i].number);
    EXPECT_EQ(sections.elements[i].type, wanted[i].type);
    EXPECT_EQ(sections.elements[i].group, wanted[i].group);
    EXPECT_EQ(sections.elements[i].nodes, wanted[i].nodes);
  }
}

TEST_F(MshSectionsTest, OfVersion41MustHoldWhatTheyAnnounce) {
  expect_unreadable(replaced(square_41, "2 4 10 40", "2 5 10 40"), {"number of nodes is 4", "5 as announced"});
  expect_unreadable(replaced(square_41, "2 4 10 40", "2 3 10 40"), {"number of nodes is 4", "3 as announced"});
  expect_unreadable(replaced(square_41, "3 3 1 3", "3 2 1 3"), {"number of elements is 3", "2 as announced"});
  expect_unreadable(replaced(square_41, "1 0 1 -7 2 1 -1", "1 0 2 7 9 2 1 -1"),
                    {"physical groups of entity 1 of dimension 1 is 2", "0 or 1"});
  expect_unreadable(replaced(square_41, "\n20\n30\n", "\n20\n10\n"), {"10, a second time", "its own"});
}

TEST_F(MshSectionsTest, OfVersion22TakeTheFirstTagAsGroup) {
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2\n5 0 0 0\n3 1 0 0\n$EndNodes\n";
  const MshSections sections = read(head + "$Elements\n3\n1 1 3 4 8 9 3 5\n2 1 1 -6 5 3\n7 15 0 3\n$EndElements\n");
  ASSERT_EQ(sections.elements.size(), 3U);
  EXPECT_EQ(sections.elements[0].group, 4);
  EXPECT_EQ(sections.elements[0].nodes, (Nodes{1, 0}));
  EXPECT_EQ(sections.elements[1].group, 6);
  EXPECT_EQ(sections.elements[2].number, 7);
  EXPECT_EQ(sections.elements[2].group, 0);
  EXPECT_EQ(sections.elements[2].nodes, (Nodes{1}));
}

TEST_F(MshSectionsTest, OfOtherNamesArePassedOver) {
  const MshSections sections = read(replaced(square_41, "$Nodes\n", "$Periodic\n$Nodes 1\n$EndPeriodic\n$Nodes\n"));
  EXPECT_EQ(sections.nodes.size(), 4U);
  expect_unreadable(replaced(square_41, "$Nodes\n", "$Periodic\n1\n$Nodes\n"), {"$EndPeriodic is missing"});
  expect_unreadable(replaced(square_41, "$Nodes\n", "Nodes\n"), {"start of a section is Nodes", "$Name"});
  expect_unreadable(replaced(square_41, "$EndEntities", "$EndNodes"), {"is $EndNodes, must be $EndEntities"});
}

TEST_F(MshSectionsTest, MustBeOfAKnownFormat) {
  expect_unreadable(replaced(block_text(), "2.2 0 8", "4 0 8"), {"line 2", "version", "is 4", "2.2 or 4.1"});
  expect_unreadable(replaced(block_text(), "2.2 0 8", "2.2 1 8"), {"binary", "0 (ASCII)"});
}

TEST_F(MshSectionsTest, MustHavePlausibleCounts) {
  for (const std::string count : {"-5", "4000000000", "99999999999999999999", "9.5"}) {
    expect_unreadable(replaced(block_text(), "$Nodes\n9\n", "$Nodes\n" + count + "\n"), {"number of nodes", count});
    expect_unreadable(replaced(block_text(), "$Elements\n12\n", "$Elements\n" + count + "\n"),
                      {"number of elements", count});
  }
  expect_unreadable(replaced(block_text(), "$Nodes\n9\n", "$Nodes\n8\n"), {"$EndNodes", "is 9"});
}

TEST_F(MshSectionsTest, MustHaveNumbersForNumbers) {
  expect_unreadable(replaced(block_text(), "5 1 -1 0", "5 1 -one 0"), {"coordinate", "-one", "a number"});
  expect_unreadable(replaced(block_text(), "5 1 -1 0", "4 1 -1 0"), {"number of a node", "4, a second time"});
}

TEST_F(MshSectionsTest, MustHaveFirstOrderElementsAlone) {
  const std::string cell = "9 3 2 10 10 1 2 5 4";
  EXPECT_EQ(read(replaced(block_text(), cell, "9 2 2 10 10 1 2 5")).elements[8].nodes.size(), 3U);
  expect_unreadable(replaced(block_text(), cell, "9 10 2 10 10 1 2 5 4 1 2 3 4 5"), {"element 9", "second order"});
  expect_unreadable(replaced(block_text(), cell, "9 5 2 10 10 1 2 5 4 1 2 3 4"), {"element 9", "solid"});
  expect_unreadable(replaced(block_text(), cell, "9 3 2 10 10 1 2 5 77"), {"element 9", "77", "number of a node"});
}

}  // namespace
}  // namespace fretval::meshes::msh_sections_test
