#include "comparison/results/surface_files.h"

#include <gtest/gtest.h>

#include <cmath>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/simulation/compute_case.h"
#include "tests/comparison/suite_case.h"
#include "tests/comparison/temporary_folder.h"
#include "tests/csv.h"

namespace fretval::surface_files_test {
namespace {

// Sums over the points of the whole circle are the forces of the history, whatever the mirrors have left out.
TEST(SurfaceFiles, HaveTheForcesInTheirPoints) {
  auto scene = suite_case("parabola-elastic-steady", 1e-2);
  scene.contact.vector_friction = true;
  BodyStore bodies;
  const auto fem = prepare({scene}).front().fem;
  const auto answer = compute_case(fem, fem.resolution, bodies);
  const TemporaryFolder folder;
  write_surface_files(answer, fem, folder.path());
  const auto points = read_csv(folder.path() / "surface.csv"), history = read_csv(folder.path() / "history.csv"),
             zones = read_csv(folder.path() / "zones.csv");
  double normal = 0, x = 0, y = 0;
  const auto n_around = zones.at("angle [rad]").size();
  for (std::size_t i = 0; i < points.at("p [Pa]").size(); ++i) {
    const double area = 3.14159265358979 *
                        (std::pow(points.at("r outer [m]")[i], 2) - std::pow(points.at("r inner [m]")[i], 2)) /
                        static_cast<double>(n_around);
    normal += area * points.at("p [Pa]")[i];
    x += area * points.at("t_x [Pa]")[i];
    y += area * points.at("t_y [Pa]")[i];
  }
  EXPECT_NEAR(normal / history.at("F_N [N]").back(), 1, 1e-9);
  EXPECT_NEAR(x / history.at("F_x [N]").back(), 1, 1e-9);
  EXPECT_NEAR(y, 0, 1e-9 * normal);
  EXPECT_NEAR(history.at("u_x [m]").back(),
              scene.motion.tangential_amplitude * std::cos(*scene.motion.phase * 0.0174532925199433), 1e-9);
  EXPECT_NEAR(zones.at("contact [m]").front(), answer.contact_radius_max.value(), 1e-9);
}

}  // namespace
}  // namespace fretval::surface_files_test
