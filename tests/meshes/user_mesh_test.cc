#include "meshes/user_mesh.h"

#include <fmt/format.h>
#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>

#include "meshes/cylinder.h"
#include "meshes/grading.h"
#include "meshes/msh_file.h"
#include "meshes/quality.h"
#include "tests/meshes/expect_error.h"
#include "tests/meshes/scratch_folder.h"

namespace fretval::meshes::user_mesh_test {
namespace {

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const auto at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return at == std::string::npos ? text : text.replace(at, part.size(), by);
}

/// Two cells above two others, 2 wide and 2 high from z = 3 up to 5, drawn upwards as people do. Nodes by rows from the
/// base on; the upper cells are the skin. In no group is the right half of the surface.
const std::string sheet = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
6
1 1 "contact"
1 2 "axis"
1 3 "base"
1 4 "side"
2 5 "pad"
2 6 "skin"
$EndPhysicalNames
$Nodes
10
1 0 3 0
2 1 3 0
3 2 3 0
4 0 4 0
5 1 4 0
6 2 4 0
7 0 5 0
8 1 5 0
9 2 5 0
99 7 7 0
$EndNodes
$Elements
13
1 1 2 1 1 7 8
2 1 2 2 2 1 4
3 1 2 2 2 4 7
4 1 2 3 3 1 2
5 1 2 3 3 2 3
6 1 2 4 4 3 6
7 1 2 4 4 6 9
8 3 2 5 1 1 2 5 4
9 3 2 5 1 2 3 6 5
10 3 2 6 2 4 7 8 5
11 3 2 6 2 5 8 9 6
12 1 2 0 7 4 5
13 15 2 0 1 1
$EndElements
)";

class UserMesh : public testing::Test {
 protected:
  Mesh read(const std::string& text) {
    write_text(file, text);
    return read_user_mesh(file);
  }
  void expect_refused(const std::string& part, const std::string& by, std::vector<std::string> parts) {
    parts.push_back(file.string());
    expect_error([&] { read(replaced(sheet, part, by)); }, parts);
  }

  ScratchFolder folder;
  std::filesystem::path file = folder / "rig.msh";
};

TEST_F(UserMesh, LiesBelowItsContactSurfaceWithTheMaterialsOfItsSurfaces) {
  const Mesh mesh = read(sheet);  // whose skin is drawn clockwise, as a whole
  EXPECT_EQ(mesh.nodes.size(), 9U);
  EXPECT_EQ(mesh.materials, (std::vector<std::string>{"pad", "skin"}));
  EXPECT_EQ(mesh.material, (std::vector<unsigned>{0, 0, 1, 1}));
  EXPECT_EQ(contact_radii(mesh), (std::vector<double>{0, 1}));
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::axis), 2);
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::base), 2);
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::free), 3) << "the side, and what is in no group";
  for (const auto& node : mesh.nodes) EXPECT_LE(node[1], 0);
}

// Such as a line for other uses, which comes first.
TEST_F(UserMesh, HasEdgesInOtherGroupsAsWell) {
  const Mesh mesh = read(replaced(sheet, "13\n1 1 2 1 1 7 8", "14\n14 1 2 4 4 7 8\n1 1 2 1 1 7 8"));
  EXPECT_EQ(contact_radii(mesh), (std::vector<double>{0, 1}));
  EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::free), 3);
}

TEST_F(UserMesh, MayBeDrawnUprightAndMissItsLinesByRoundoff) {
  std::string upright = sheet;
  for (const auto& [from, to] : {std::pair{"7 0 5 0", "7 1e-15 0 5"},
                                 {"8 1 5 0", "8 1 0 4.99999999999999"},
                                 {"9 2 5 0", "9 2 0 5"},
                                 {"4 0 4 0", "4 -1e-16 0 4"},
                                 {"5 1 4 0", "5 1 0 4"},
                                 {"6 2 4 0", "6 2 0 4"},
                                 {"1 0 3 0", "1 0 0 3"},
                                 {"2 1 3 0", "2 1 0 3"},
                                 {"3 2 3 0", "3 2 0 3"},
                                 {"99 7 7 0", "99 7 0 7"}})
    upright = replaced(upright, std::string("\n") + from + "\n", std::string("\n") + to + "\n");
  EXPECT_EQ(read(upright).nodes, read(sheet).nodes);
}

/// The sheet with all lengths times a factor, and the middle node of its surface lower by a part of its size.
std::string scaled_sheet(double factor, double lower_by) {
  std::string nodes = "$Nodes\n9\n";
  for (int k = 0; k < 9; ++k)
    nodes += fmt::format("{} {:.17g} {:.17g} 0\n", k + 1, factor * (k % 3),
                         factor * (k / 3 + 3 - (k == 7 ? 2 * lower_by : 0)));  // 2 is the size
  const auto begin = sheet.find("$Nodes"), end = sheet.find("$EndNodes");
  return sheet.substr(0, begin) + nodes + sheet.substr(end);
}

// Nothing is known of the unit of length: what counts as roundoff is a part of the size.
TEST_F(UserMesh, MissesItsLinesByAPartOfItsSizeInAnyUnit) {
  for (const double factor : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    const Mesh mesh = read(scaled_sheet(factor, 1e-10));
    EXPECT_NEAR(contact_radii(mesh).back(), factor, 1e-12 * factor);
    expect_error([&] { read(scaled_sheet(factor, 1e-7)); }, {"\"contact\" reaches from z", "must be level"});
  }
}

TEST_F(UserMesh, OfOursIsTheSameMesh) {
  const Mesh ours = cylinder({uniform_nodes(1, 8), 1.5, 3, 0.3});
  write_msh(ours, file);
  const Mesh mesh = read_user_mesh(file);
  EXPECT_EQ(mesh.cells.size(), ours.cells.size());
  EXPECT_EQ(contact_radii(mesh), contact_radii(ours));
  for (const Boundary boundary : all_boundaries)
    EXPECT_NEAR(boundary_length(mesh, boundary), boundary_length(ours, boundary), 1e-12);
  EXPECT_EQ(mesh.materials, std::vector<std::string>{"body"});
}

TEST_F(UserMesh, NeedsItsGroups) {
  expect_refused("\"contact\"", "\"touch\"",
                 {"\"contact\" has no elements", "\"axis\", \"base\", \"side\", \"touch\""});
  expect_refused("\"axis\"", "\"middle\"", {"\"axis\" has no elements"});
  expect_refused("\"base\"", "\"ground\"", {"\"base\" has no elements"});
  expect_refused("\"side\"", "\"far\"", {"\"far\" cuts off a half-space"});
  EXPECT_NO_THROW(read(replaced(sheet, "\"side\"", "\"wall\"")));
}

TEST_F(UserMesh, NeedsAContactSurfaceThatIsTheLevelTopFromTheAxisOn) {
  expect_refused("8 1 5 0", "8 1 4.9 0", {"\"contact\" reaches from z = 4.9 to 5", "must be level"});
  expect_refused("9 2 5 0", "9 2 5.5 0", {"(2, 5.5) lies above the contact surface, z = 5"});
  expect_refused("1 1 2 1 1 7 8", "1 1 2 1 1 8 9", {"the contact line has no edge from r = 0 to 1"});
  expect_refused("1 1 2 1 1 7 8", "1 1 2 1 1 4 5", {"\"contact\" from (0, 4) to (1, 4) belongs to 2 cells"});
  expect_refused("7 0 5 0", "7 0.2 5 0", {"axis edge", "r = 0.2", "must be on r = 0"});
}

TEST_F(UserMesh, NeedsCellsThatFitTogether) {
  expect_refused("9 3 2 5 1 2 3 6 5", "9 3 2 5 1 5 6 3 2", {"cell 1", "inverted (clockwise)"});
  expect_refused("9 3 2 5 1 2 3 6 5", "9 3 2 5 1 2 3 5 6", {"cell 1", "bow-tie"});
  expect_refused("5 1 4 0", "5 1 4 0.5", {"node 5", "out of the plane"});
  expect_refused("8 3 2 5 1 1 2 5 4", "8 5 2 5 1 1 2 5 4 7 8 9 6", {"element 8", "solid", "3 (4-node"});
  std::string lines = sheet;
  for (const char* cell :
       {"8 3 2 5 1 1 2 5 4\n", "9 3 2 5 1 2 3 6 5\n", "10 3 2 6 2 4 7 8 5\n", "11 3 2 6 2 5 8 9 6\n"})
    lines = replaced(lines, cell, "");
  expect_error([&] { read(replaced(lines, "$Elements\n13", "$Elements\n9")); },
               {file.string(), "no triangle or quadrilateral", "the meridian section"});
}

TEST_F(UserMesh, HasNoHangingNodes) {
  // The right one of the pad's cells is two, side by side, of which the skin knows nothing.
  std::string text = replaced(sheet, "99 7 7 0\n", "99 1.5 3 0\n98 1.5 4 0\n");
  text = replaced(replaced(text, "$Nodes\n10", "$Nodes\n11"), "$Elements\n13", "$Elements\n15");
  text = replaced(text, "9 3 2 5 1 2 3 6 5\n", "9 3 2 5 1 2 99 98 5\n14 3 2 5 1 99 3 6 98\n");
  text = replaced(text, "5 1 2 3 3 2 3\n", "5 1 2 3 3 2 99\n15 1 2 3 3 99 3\n");
  expect_error([&] { read(text); }, {file.string(), "(1.5, -1) hangs on the edge"});
}

TEST_F(UserMesh, OfTrianglesBecomesQuadrilaterals) {
  std::string text = replaced(sheet, "8 3 2 5 1 1 2 5 4\n", "8 2 2 5 1 1 2 5\n14 2 2 5 1 1 5 4\n");
  const Mesh mesh = read(replaced(text, "$Elements\n13", "$Elements\n14"));
  EXPECT_EQ(mesh.cells.size(), 3 * 4U + 2 * 3U);
  EXPECT_EQ(contact_radii(mesh), (std::vector<double>{0, 0.5, 1}));
  EXPECT_DOUBLE_EQ(quality(mesh).area, 4);
}

/// gmsh's own files, of both versions, with two surfaces of opposite senses.
TEST_F(UserMesh, OfGmshIsReadInBothVersions) {
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  namespace geo = gmsh::model::geo;
  std::vector<int> points;
  for (const double z : {0., 2., 3.})
    for (const double r : {0., 1., 4.}) points.push_back(geo::addPoint(r, z, 0, r > 1 ? 1 : 0.25));
  const auto line = [&](int a, int b) { return geo::addLine(points[a], points[b]); };
  const int base = line(0, 2), side = line(2, 5), middle = line(5, 3), axis = line(3, 0), upper_side = line(5, 8),
            top = line(8, 7), contact = line(7, 6), upper_axis = line(6, 3);
  const int pad = geo::addPlaneSurface({geo::addCurveLoop({base, side, middle, axis})}),
            skin = geo::addPlaneSurface({geo::addCurveLoop({-middle, upper_side, top, contact, upper_axis})});
  geo::synchronize();
  const auto name = [](int dimension, const std::vector<int>& entities, const std::string& text) {
    gmsh::model::setPhysicalName(dimension, gmsh::model::addPhysicalGroup(dimension, entities), text);
  };
  name(1, {contact}, "contact");
  name(1, {axis, upper_axis}, "axis");
  name(1, {base}, "base");
  name(1, {side, upper_side}, "side");
  name(2, {pad}, "pad");
  name(2, {skin}, "skin");
  gmsh::model::mesh::generate(2);
  std::vector<Mesh> meshes;
  for (const double version : {2.2, 4.1}) {
    gmsh::option::setNumber("Mesh.MshFileVersion", version);
    gmsh::write(file.string());
    meshes.push_back(read_user_mesh(file));
  }
  gmsh::finalize();
  for (const Mesh& mesh : meshes) {
    EXPECT_EQ(mesh.materials, (std::vector<std::string>{"pad", "skin"}));
    EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::contact), 1);
    EXPECT_DOUBLE_EQ(boundary_length(mesh, Boundary::axis), 3);
    EXPECT_NEAR(quality(mesh).area, 12, 1e-12);
  }
  EXPECT_EQ(meshes[0].cells.size(), meshes[1].cells.size());
}

}  // namespace
}  // namespace fretval::meshes::user_mesh_test
