#include "comparison/verification/small/small_suite.h"

#include <fmt/format.h>

#include <map>

#include "comparison/case/case_file.h"
#include "comparison/support/junit.h"
#include "meshes/msh_file.h"

namespace fretval {

namespace fs = std::filesystem;

fs::path small_meshes() {
  return FRETVAL_SMALL_MESHES;
}

std::vector<SmallCase> small_cases(const fs::path& meshes) {
  // 20 and 40 rings per contact radius. Measured at worst: stick radius 4.9e-5 and 1.7e-5, contact radius 1.2e-4 twice
  // (time steps of the Kelvin-Voigt cone), normal force 9.2e-5 and 3.5e-5.
  struct SmallMesh {
    const char* name;
    Tolerances tolerances;
  };
  std::vector<SmallCase> cases;
  for (const auto& mesh : {SmallMesh{"coarse", {1e-4, 2e-4, 2e-4}}, SmallMesh{"fine", {4e-5, 1.2e-4, 6e-5}}})
    for (const char* name : {"parabola-standard-solid", "cone-kelvin-voigt", "parabola-no-first-slip-zone"}) {
      const fs::path folder(FRETVAL_CHECK_CASES);
      for (auto& prepared : prepare(read_case_file(folder / (std::string(name) + ".prm")))) {
        prepared.input.name += std::string("/") + mesh.name;
        prepared.tolerances = mesh.tolerances;
        cases.push_back({std::move(prepared), meshes / (std::string(mesh.name) + ".msh")});
      }
    }
  return cases;
}

std::vector<BatchLine> run_small_suite(const std::vector<SmallCase>& all) {
  std::map<fs::path, std::vector<PreparedCase>> by_mesh;
  for (const auto& one : all) by_mesh[one.mesh].push_back(one.prepared);
  std::vector<BatchLine> lines;
  for (const auto& [mesh, cases] : by_mesh) {
    // Read here: a damaged file is bad input, not a failure of the numerics.
    const auto committed = meshes::read_msh(mesh);
    const MeshSource meshes{mesh.string(), [&](const BodySpecification&) { return committed; }};
    for (auto& line : run_batch(cases, {Proof::none, meshes})) lines.push_back(std::move(line));
  }
  return lines;
}

std::string junit_xml(const std::vector<BatchLine>& lines) {
  std::vector<JUnitCase> cases;
  for (const auto& line : lines) {
    std::string failure = line.failure;
    for (const auto& [quantity, d] : line.comparison)
      if (!d.passes())
        failure += fmt::format("{}: difference {}, tolerance {:.1e}; ", name_of(quantity),
                               d.difference ? fmt::format("{:.2e}", *d.difference) : "none", d.tolerance);
    if (failure.empty() && !line.pass) failure = "failed";
    cases.push_back({line.name, failure});
  }
  return junit_document("fretval check", cases);
}

}  // namespace fretval
