#include <gmsh.h>
#include <gtest/gtest.h>

#include <cmath>

#include "meshes/audit.h"
#include "meshes/grading.h"
#include "meshes/msh_file.h"
#include "meshes/quarter_disc.h"
#include "tests/meshes/expect_error.h"
#include "tests/meshes/scratch_folder.h"

namespace fretval::meshes::gmsh_file_test {
namespace {

/// gmsh reads what we write, and we read what it writes.
class GmshFile : public testing::Test {
 protected:
  GmshFile() {
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
  }
  ~GmshFile() override { gmsh::finalize(); }

  /// A quarter disc of radius 10 with a contact line of length 1, as a user would draw it, in either sense.
  static void draw_quarter_disc(bool clockwise) {
    namespace geo = gmsh::model::geo;
    const int centre = geo::addPoint(0., 0., 0., 0.2);
    const int edge = geo::addPoint(1., 0., 0., 0.2);
    const int right = geo::addPoint(10., 0., 0., 2.);
    const int bottom = geo::addPoint(0., -10., 0., 2.);
    const int contact = geo::addLine(centre, edge);
    const int free = geo::addLine(edge, right);
    const int far = geo::addCircleArc(right, centre, bottom);
    const int axis = geo::addLine(bottom, centre);
    const std::vector<int> loop =
        clockwise ? std::vector<int>{contact, free, far, axis} : std::vector<int>{-axis, -far, -free, -contact};
    const int body = geo::addPlaneSurface({geo::addCurveLoop(loop)});
    geo::synchronize();
    const auto add_group = [](int dimension, int entity, const std::string& name) {
      gmsh::model::setPhysicalName(dimension, gmsh::model::addPhysicalGroup(dimension, {entity}), name);
    };
    add_group(1, contact, "contact");
    add_group(1, free, "free");
    add_group(1, far, "far");
    add_group(1, axis, "axis");
    add_group(2, body, "body");
    add_group(0, edge, "edge of the contact line");
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 1);
  }

  ScratchFolder folder;
  std::string file = (folder / "gmsh.msh").string();
};

TEST_F(GmshFile, OfBothVersionsAndSensesIsReadable) {
  for (const double version : {2.2, 4.1})
    for (const bool clockwise : {false, true}) {
      SCOPED_TRACE(version);
      gmsh::clear();
      draw_quarter_disc(clockwise);
      gmsh::model::mesh::generate(2);
      gmsh::option::setNumber("Mesh.MshFileVersion", version);
      gmsh::write(file);
      const Mesh mesh = read_msh(file);
      EXPECT_NO_THROW(audit(mesh, file));
      EXPECT_NEAR(boundary_length(mesh, Boundary::axis), 10., 1e-12);
      EXPECT_NEAR(boundary_length(mesh, Boundary::contact), 1., 1e-12);
      EXPECT_NEAR(boundary_length(mesh, Boundary::free), 9., 1e-12);
      // Chords of up to 2 in a circle of 10 are short by 1/600 at most.
      EXPECT_NEAR(boundary_length(mesh, Boundary::far), 5. * std::acos(-1.), 5. * std::acos(-1.) / 600.);
    }
}

TEST_F(GmshFile, WithParametersOfNodesIsReadable) {
  draw_quarter_disc(false);
  gmsh::model::mesh::generate(2);
  gmsh::option::setNumber("Mesh.SaveParametric", 1);
  gmsh::write(file);
  EXPECT_NO_THROW(audit(read_msh(file), file));
}

TEST_F(GmshFile, OfTrianglesOrSecondOrderIsRefused) {
  draw_quarter_disc(false);
  gmsh::option::setNumber("Mesh.RecombineAll", 0);
  gmsh::option::setNumber("Mesh.SubdivisionAlgorithm", 0);
  gmsh::model::mesh::generate(2);
  gmsh::write(file);
  expect_error([this] { read_msh(file); }, {file, "triangle"});
  gmsh::model::mesh::setOrder(2);
  gmsh::write(file);
  expect_error([this] { read_msh(file); }, {file, "second order"});
}

TEST_F(GmshFile, InBinaryIsRefused) {
  draw_quarter_disc(false);
  gmsh::model::mesh::generate(2);
  gmsh::option::setNumber("Mesh.Binary", 1);
  gmsh::write(file);
  expect_error([this] { read_msh(file); }, {file, "binary"});
}

TEST_F(GmshFile, WithAnEntityInTwoGroupsIsRefused) {
  draw_quarter_disc(false);
  gmsh::model::setPhysicalName(1, gmsh::model::addPhysicalGroup(1, {1}), "again");
  gmsh::model::mesh::generate(2);
  gmsh::write(file);
  expect_error([this] { read_msh(file); }, {file, "entity 1 of dimension 1", "is 2", "0 or 1"});
}

TEST_F(GmshFile, OfOursIsUnderstoodByGmsh) {
  gmsh::finalize();
  const Mesh mesh = quarter_disc({uniform_nodes(1., 8), 20.});
  gmsh::initialize(0, nullptr, false);
  gmsh::option::setNumber("General.Terminal", 0);
  write_msh(mesh, file);
  gmsh::open(file);
  for (const Boundary boundary : {Boundary::axis, Boundary::contact, Boundary::free, Boundary::far}) {
    const int group = static_cast<int>(boundary);
    std::string name;
    gmsh::model::getPhysicalName(1, group, name);
    EXPECT_EQ(name, boundary_name(boundary));
  }
  const auto n_elements = [](int type) {
    std::vector<std::size_t> elements;
    std::vector<std::size_t> nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes);
    return elements.size();
  };
  EXPECT_EQ(n_elements(3), mesh.cells.size());
  EXPECT_EQ(n_elements(1), mesh.edges.size());
}

}  // namespace
}  // namespace fretval::meshes::gmsh_file_test
