#include <gtest/gtest.h>

#include "comparison/case_file/case_sections.h"
#include "comparison/support/content_hash.h"
#include "comparison/support/files.h"
#include "meshes/mesh.h"
#include "tests/comparison/expect_parts.h"
#include "tests/comparison/given_mesh.h"

namespace fretval::mesh_entries_test {
namespace {

class MeshEntries : public testing::Test {
 protected:
  Case::Body read(const std::string& more = "", bool with_skin = true) {
    return case_with_mesh(folder, pad_mesh(16, with_skin), more).body;
  }
  void expect_refused(const std::string& more, const std::vector<std::string>& parts) {
    expect_parts(refusal([&] { read(more); }), parts);
  }
  ScratchFolder folder;
};

TEST_F(MeshEntries, AreAMeshWithTheMaterialsOfItsSurfaces) {
  const auto body = read("  set Relative moduli = skin 8\n");
  EXPECT_EQ(body.shape, Case::Body::Shape::mesh);
  EXPECT_NEAR(body.thickness, 3e-3, 1e-12);
  EXPECT_EQ(body.mesh_unit, 1e-3);
  EXPECT_EQ(meshes::contact_radii(*body.grid).size(), 17U);
  EXPECT_EQ(body.mesh_hash, content_hash(content_of(folder.path() / "rig.msh")));
  EXPECT_EQ(moduli_of_materials(body), (std::vector<double>{8, 1}));
  EXPECT_EQ(moduli_of_materials(read("  set Relative moduli = skin = 0.5, pad: 2\n")), (std::vector<double>{0.5, 2}));
  EXPECT_EQ(moduli_of_materials(read()), (std::vector<double>{1, 1}));
  EXPECT_TRUE(has_level_base(*body.grid));
}

TEST_F(MeshEntries, HaveAUnitAsAWordOrALength) {
  for (const auto& [text, unit] : {std::pair{"cm", 1e-2}, {"25.4 mm", 25.4e-3}, {"1e-3", 1e-3}}) {
    auto text_of_case = replace(case_on_mesh(), "Mesh unit = mm", std::string("Mesh unit = ") + text);
    meshes::write_msh(pad_mesh(16), folder.path() / "rig.msh");
    EXPECT_DOUBLE_EQ(read_case_file(folder.write("unit.prm", text_of_case)).front().body.mesh_unit, unit);
  }
  const auto furlong = replace(case_on_mesh(), "Mesh unit = mm", "Mesh unit = furlong");
  expect_parts(refusal([&] { read_case_file(folder.write("unit.prm", furlong)); }),
               {"Body / Mesh unit = furlong", "a unit of length"});
}

TEST_F(MeshEntries, AreRefusedByName) {
  expect_refused("  set Relative moduli = skn 8\n",
                 {"Body / Relative moduli = skn 8", "skin, pad", "there is no skn", "did you mean skin?"});
  expect_refused("  set Relative moduli = skin -8\n", {"Relative moduli = skin -8", "positive number"});
  expect_refused("  set Relative moduli = skin\n", {"Relative moduli = skin", "as pad 1, skin 8"});
  expect_refused("  set Relative moduli = skin 2, skin 3\n", {"each name once"});
  expect_refused("  set Thickness = 3 mm\n", {"Body / Thickness", "layer or cylinder, not to mesh"});
  const auto no_mesh = replace(case_on_mesh(), "rig.msh", "missing.msh");
  expect_parts(refusal([&] { read_case_file(folder.write("a.prm", no_mesh)); }),
               {"Body / Mesh = missing.msh", "the name of a file"});
  const auto rings =
      replace(case_on_mesh(), "set Tolerance = 0.01", "set Tolerance = 0.01\n  set Rings per radius = 32");
  meshes::write_msh(pad_mesh(16), folder.path() / "rig.msh");
  expect_parts(refusal([&] { read_case_file(folder.write("a.prm", rings)); }),
               {"Accuracy / Rings per radius = 32", "rings are the edges of the Body / Mesh"});
}

TEST_F(MeshEntries, NameTheFileAndWhatIsWrongWithIt) {
  auto mesh = pad_mesh(16);
  for (auto& edge : mesh.edges)
    if (edge.boundary == meshes::Boundary::base) edge.boundary = meshes::Boundary::free;
  expect_parts(refusal([&] { case_with_mesh(folder, mesh); }),
               {"rig.prm: Body / Mesh = rig.msh", "\"base\" has no elements"});
  mesh = pad_mesh(16);
  std::swap(mesh.cells[3][1], mesh.cells[3][3]);
  expect_parts(refusal([&] { case_with_mesh(folder, mesh); }), {"Body / Mesh = rig.msh", "clockwise"});
}

TEST_F(MeshEntries, SlideOnALevelBaseAloneAndWithoutTangentialMotion) {
  auto still = replace(replace(case_on_mesh(), "Base = bonded", "Base = frictionless"), "Tangential amplitude = 1.5e-5",
                       "Tangential amplitude = 0");
  meshes::write_msh(pad_mesh(16), folder.path() / "rig.msh");
  EXPECT_FALSE(read_case_file(folder.write("a.prm", still)).front().body.is_bonded);
  auto mesh = pad_mesh(16);
  for (auto& node : mesh.nodes)
    if (node[1] < -2.99) node[1] -= 0.05 * node[0];
  meshes::write_msh(mesh, folder.path() / "rig.msh");
  expect_parts(refusal([&] { read_case_file(folder.write("a.prm", still)); }),
               {"Body / Base = frictionless", "is not level"});
  const auto moving = replace(case_on_mesh(), "Base = bonded", "Base = frictionless");
  expect_parts(refusal([&] { read_case_file(folder.write("a.prm", moving)); }),
               {"Body / Base = frictionless", "holds the body"});
}

}  // namespace
}  // namespace fretval::mesh_entries_test
