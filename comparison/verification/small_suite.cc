#include "comparison/support/files.h"
#include "comparison/support/folders.h"
#include "comparison/verification/suites.h"
#include "meshes/audit.h"
#include "meshes/msh_file.h"

namespace fretval {
namespace {

namespace fs = std::filesystem;

std::shared_ptr<BodyStore> bodies_on(const fs::path& file) {
  // Read here: a damaged file is bad input, not a failure of the numerics.
  const auto mesh = meshes::read_msh(file);
  meshes::audit(mesh, file.string());
  return std::make_shared<BodyStore>(MeshSource{file.string(), [=](const BodyDescription&) { return mesh; }});
}

}  // namespace

fs::path small_meshes() {
  return data_folder() / "meshes" / "small";
}

std::vector<SuiteCase> small_cases(const fs::path& meshes) {
  // 20 and 40 rings per contact radius. Rings are of third order with constants below 1, 1.25e-4 and 1.6e-5; steps
  // leave 2e-5 to 3e-5 whatever the mesh. Measured at worst: stick radius 4.9e-5 and 1.8e-5, contact radius 3.3e-5
  // twice (time steps), normal force 4.3e-5 and 1.6e-5.
  const std::vector<std::pair<std::string, Tolerances>> all_meshes{{"coarse", {1e-4, 1e-4, 1e-4}},
                                                                   {"fine", {4e-5, 7e-5, 4e-5}}};
  std::vector<SuiteCase> cases;
  for (const auto& [mesh, tolerances] : all_meshes) {
    const auto bodies = bodies_on(meshes / (mesh + ".msh"));
    for (const std::string name : {"parabola-standard-solid", "cone-kelvin-voigt", "parabola-no-first-slip-zone"}) {
      SuiteCase one{mesh + " mesh", name, content_of(data_folder() / "cases" / "check" / (name + ".prm"))};
      one.proof = Proof::none;
      one.change = [t = tolerances](PreparedCase& prepared) { prepared.tolerances = t; };
      one.bodies = bodies;
      cases.push_back(std::move(one));
    }
  }
  return cases;
}

SuiteRun run_small_suite(const fs::path& meshes) {
  return run_suite("small", "Small cases on the committed meshes, without error bars.", small_cases(meshes));
}

}  // namespace fretval
