#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "comparison/accuracy/prepared_case.h"
#include "comparison/results/case_result.h"
#include "comparison/results/results_folder.h"
#include "comparison/simulation/compute_case.h"
#include "tests/comparison/made_up_result.h"
#include "tests/comparison/run_fretval.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/suite_case.h"
#include "tests/fem/vtu_data.h"

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

/// On two rings and four angles, of which a mirror leaves two. A length of 1 is 2 m, a depth 0.5 m, a pressure 2.5 Pa,
/// a force 10 N; the second of two cycles, of four steps that take 1 s. Each number is another one.
CaseResult made_up_surface() {
  auto result = made_up_result();
  result.fem_case.resolution.steps_per_cycle = 4;
  SurfaceAnswer surface;
  surface.grid = fem::angular_grid(4, fem::Mirrors::x);
  surface.contact.edges = {3, 2.9};
  surface.never_slipped.edges = {0.6, 0.4};
  surface.sticks_in_a_cycle.edges = {0.8, 0.7};
  auto& history = surface.history;
  history.n_cycles = 2;
  history.forces.resize(3, 4);
  history.forces << 1, 2, 3, 4, 0.5, 0.6, 0.7, 0.8, -0.1, -0.2, -0.3, -0.4;
  history.displacement.resize(2, 4);
  history.displacement << 0.1, 0.2, 0.3, 0.4, 0.01, 0.02, 0.03, 0.04;
  history.normal_force = Eigen::Vector4d(5, 6, 7, 8);
  history.pressure.assign(2, Eigen::MatrixXd::Zero(2, 2));
  history.pressure.back() << 4, 3, 2, 0;
  history.traction.assign(2, Eigen::MatrixXd::Zero(2, 4));
  history.traction.back() << 1, 2, 0.1, 0.2, 3, 0, 0.3, 0;
  result.fe.fe.of_kind = surface;
  return result;
}

struct ExpectedColumn {
  const char* name;
  std::vector<double> values;
};

void expect_columns(const std::filesystem::path& file, const std::vector<ExpectedColumn>& expected) {
  EXPECT_EQ(column_names(file).size(), expected.size()) << file;
  for (const auto& [name, values] : expected) {
    const auto found = read_columns(file, name, name).second;
    ASSERT_EQ(found.size(), values.size()) << name;
    for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(found[k], values[k], 1e-8) << name << ' ' << k;
  }
}

// The cycle of d = (0.75 + 0.25 cos) 0.5 m begins at 4 s at its deepest.
TEST(SurfaceFiles, HaveEveryNumberInItsUnit) {
  const auto result = made_up_surface();
  const ScratchFolder folder;
  write_surface_files(result.fe.fe, result.fem_case, folder.path());
  expect_columns(folder.path() / "history.csv", {{"t [s]", {5, 6, 7, 8}},
                                                 {"d [m]", {0.375, 0.25, 0.375, 0.5}},
                                                 {"u_x [m]", {0.05, 0.1, 0.15, 0.2}},
                                                 {"u_y [m]", {0.005, 0.01, 0.015, 0.02}},
                                                 {"F_N [N]", {50, 60, 70, 80}},
                                                 {"F_x [N]", {10, 20, 30, 40}},
                                                 {"F_y [N]", {5, 6, 7, 8}},
                                                 {"M_z [N m]", {-2, -4, -6, -8}}});
  // Below the x axis t_y is the other way round.
  const double eighth = std::acos(-1.0) / 4;
  const std::vector<double> angles{eighth, 3 * eighth, 5 * eighth, 7 * eighth};
  expect_columns(
      folder.path() / "surface.csv",
      {{"r inner [m]", {0, 0, 0, 0, 1, 1, 1, 1}},
       {"r outer [m]", {1, 1, 1, 1, 3, 3, 3, 3}},
       {"angle [rad]", {angles[0], angles[1], angles[2], angles[3], angles[0], angles[1], angles[2], angles[3]}},
       {"p [Pa]", {10, 7.5, 7.5, 10, 5, 0, 0, 5}},
       {"t_x [Pa]", {2.5, 5, 5, 2.5, 7.5, 0, 0, 7.5}},
       {"t_y [Pa]", {0.25, 0.5, -0.5, -0.25, 0.75, 0, 0, -0.75}},
       {"never slipped [1]", {1, 0, 0, 1, 0, 0, 0, 0}},
       {"sticks in a cycle [1]", {1, 1, 1, 1, 0, 0, 0, 0}}});
  expect_columns(folder.path() / "zones.csv", {{"angle [rad]", angles},
                                               {"contact [m]", {3, 2.9, 2.9, 3}},
                                               {"never slipped [m]", {0.6, 0.4, 0.4, 0.6}},
                                               {"sticks in a cycle [m]", {0.8, 0.7, 0.7, 0.8}}});
}

// Under a normal force the depth is the one that balances it, which a contact of given pressures does not have.
TEST(SurfaceFiles, HaveTheDepthThatBalancesAForce) {
  auto result = made_up_surface();
  result.fem_case.motion.normal_force = true;
  const ScratchFolder folder;
  write_surface_files(result.fe.fe, result.fem_case, folder.path());
  EXPECT_EQ(column_names(folder.path() / "history.csv"),
            (std::vector<std::string>{"t [s]", "u_x [m]", "u_y [m]", "F_N [N]", "F_x [N]", "F_y [N]", "M_z [N m]"}));
  std::get<SurfaceAnswer>(result.fe.fe.of_kind).history.depth = Eigen::Vector4d(0.1, 0.2, 0.3, 0.4);
  write_surface_files(result.fe.fe, result.fem_case, folder.path());
  EXPECT_EQ(read_columns(folder.path() / "history.csv", "t [s]", "d [m]").second,
            (std::vector<double>{0.05, 0.1, 0.15, 0.2}));
}

// Six pieces around each point, whose corners go from the inner to the outer edge and then around the axis.
TEST(SurfaceFiles, ShowEachPointOnItsPieceOfARing) {
  const auto result = made_up_surface();
  const ScratchFolder folder;
  write_surface_files(result.fe.fe, result.fem_case, folder.path());
  const auto vtu = text_of(folder.path() / "surface.vtu");
  const auto at = vtu_data(vtu, ""), traction = vtu_data(vtu, "traction (Pa)"),
             pressure = vtu_data(vtu, "contact pressure (Pa)"),
             zone = vtu_data(vtu, "zone (0 open, 1 slips, 2 sticks in a cycle, 3 has never slipped)");
  constexpr std::size_t n_of_point = 6 * 4;
  ASSERT_EQ(zone.size(), 8 * n_of_point);
  const float zones[]{3, 2, 2, 3, 1, 0, 0, 1}, pressures[]{10, 7.5, 7.5, 10, 5, 0, 0, 5},
      across[]{0.25F, 0.5F, -0.5F, -0.25F, 0.75F, 0, 0, -0.75F};
  double area = 0;
  for (std::size_t k = 0; k < zone.size(); ++k) {
    EXPECT_EQ(zone[k], zones[k / n_of_point]) << k;
    EXPECT_EQ(pressure[k], pressures[k / n_of_point]) << k;
    EXPECT_EQ(traction[3 * k + 1], across[k / n_of_point]) << k;
    EXPECT_EQ(traction[3 * k + 2], pressures[k / n_of_point]) << k;
    EXPECT_NEAR(std::hypot(at[3 * k], at[3 * k + 1]), k < 4 * n_of_point ? k % 2 : 1 + 2 * (k % 2), 1e-6) << k;
    if (k % 4 != 0) continue;
    const auto x = [&](std::size_t corner) { return at[3 * (k + corner)]; };
    const auto y = [&](std::size_t corner) { return at[3 * (k + corner) + 1]; };
    area += ((x(3) - x(0)) * (y(2) - y(1)) - (x(2) - x(1)) * (y(3) - y(0))) / 2;
  }
  EXPECT_NEAR(area, 9 * 24 * std::sin(std::acos(-1.0) / 12) / 2, 1e-4) << "of a polygon of 24 corners";
}

}  // namespace
}  // namespace fretval::surface_files_test
