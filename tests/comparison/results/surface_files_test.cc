#include "comparison/results/surface_files.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/results/results_folder.h"
#include "comparison/simulation/compute_case.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/suite_case.h"

namespace fretval::surface_files_test {
namespace {

// Sums over the points of the whole circle are the forces of the history, whatever the mirrors have left out.
TEST(SurfaceFiles, HaveTheForcesInTheirPoints) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.contact.vector_friction = true;
  BodyStore bodies;
  const auto fem = prepare({scene}).front().fem;
  const auto answer = compute_case(fem, fem.resolution, bodies);
  const ScratchFolder folder;
  write_surface_files(answer, fem, folder.path());
  const auto column = [&](const char* file, const char* name) {
    return read_columns(folder.path() / file, name, name).second;
  };
  const auto inner = column("surface.csv", "r inner [m]"), outer = column("surface.csv", "r outer [m]"),
             p = column("surface.csv", "p [Pa]"), along = column("surface.csv", "t_x [Pa]"),
             across = column("surface.csv", "t_y [Pa]");
  const auto n_around = static_cast<double>(column("zones.csv", "angle [rad]").size());
  double normal = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double area = 3.14159265358979 * (outer[i] * outer[i] - inner[i] * inner[i]) / n_around;
    normal += area * p[i];
    x += area * along[i];
    y += area * across[i];
  }
  EXPECT_NEAR(normal / column("history.csv", "F_N [N]").back(), 1, 1e-8);
  EXPECT_NEAR(x / column("history.csv", "F_x [N]").back(), 1, 1e-8);
  EXPECT_NEAR(y, 0, 1e-9 * normal);
  EXPECT_NEAR(column("history.csv", "u_x [m]").back(),
              scene.motion.tangential_amplitude * std::cos(*scene.motion.phase * 0.0174532925199433), 1e-9);
  EXPECT_NEAR(column("zones.csv", "contact [m]").front(), answer.contact_radius_max.value(), 1e-9);
  const auto vtu = text_of(folder.path() / "surface.vtu");
  for (const char* part : {"traction (Pa)", "contact pressure (Pa)", "has never slipped"})
    EXPECT_NE(vtu.find(part), std::string::npos) << part;
  const auto n_cells = std::to_string(6 * p.size());
  EXPECT_NE(vtu.find("NumberOfCells=\"" + n_cells + "\""), std::string::npos) << n_cells;
}

}  // namespace
}  // namespace fretval::surface_files_test
