#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "meshes/audit.h"
#include "meshes/msh_file.h"
#include "tests/comparison/scratch_folder.h"

/// A mesh is read and audited, or refused; one that passes is the same after it is written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fretval::meshes;
  static const fretval::ScratchFolder folder;
  const auto file = folder.write("mesh.msh", std::string(reinterpret_cast<const char*>(data), size));
  try {
    const Mesh mesh = read_msh(file);
    audit(mesh, file.string());
    const auto copy_file = folder.path() / "copy.msh";
    write_msh(mesh, copy_file);
    const Mesh copy = read_msh(copy_file);
    if (copy.nodes != mesh.nodes || copy.cells != mesh.cells || copy.edges.size() != mesh.edges.size()) std::abort();
  } catch (const MeshError&) {
  }
  return 0;
}
