#pragma once

#include <string>

#include "comparison/case_file/case_file.h"
#include "meshes/cylinder.h"
#include "meshes/grading.h"
#include "meshes/msh_file.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval {

/// The mesh of a bonded pad of 3 mm, 6 mm in radius, with n equal rings on 1.5 mm, in mm; half of it may be a skin.
inline meshes::Mesh pad_mesh(unsigned n_rings = 32, bool with_skin = false) {
  auto mesh = meshes::cylinder({meshes::uniform_nodes(1.5, n_rings), 3, 6, 0.4});
  if (!with_skin) return mesh;
  mesh.materials = {"pad", "skin"};
  for (const auto& cell : mesh.cells) {
    double z = 0;
    for (const unsigned node : cell) z += mesh.nodes[node][1] / 4;
    mesh.material.push_back(z > -0.5 ? 1 : 0);
  }
  return mesh;
}

/// The valid case on a mesh of its own, which lies beside it as rig.msh.
inline std::string case_on_mesh(const std::string& more = "") {
  return valid_case + "subsection Body\n  set Shape = mesh\n  set Mesh = rig.msh\n  set Mesh unit = mm\n" +
         "  set Base = bonded\n" + more + "end\n";
}

inline Case case_with_mesh(const ScratchFolder& folder, const meshes::Mesh& mesh, const std::string& more = "") {
  meshes::write_msh(mesh, folder.path() / "rig.msh");
  return read_case_file(folder.write("rig.prm", case_on_mesh(more))).front();
}

}  // namespace fretval
