#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <tuple>

#include "comparison/results/case_result.h"
#include "comparison/results/results_folder.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "tests/comparison/scratch_folder.h"
#include "tests/comparison/wearing_case.h"

namespace fretval::wear_json_test {
namespace {

const Units units{1e-3, 1e-4, 1e6, 6.0};  // m, m, Pa, rad/s

/// Two rings, of which the outer one wears.
ProvedWear made_up_wear() {
  ProvedWear wear{{},
                  {},
                  {},
                  {wear_limit(mdr::limiting_profile(mdr::parabola(1e-2), 5e-4, 1e-4)),
                   wear_limit(mdr::limiting_profile(mdr::parabola(1e-2), 4e-4, 1e-4))}};
  auto& course = wear.fe.course;
  wear.fe.radii = {0, 0.5, 1};
  wear.fe.centre = Eigen::Vector2d(0.25, 0.75);
  wear.fe.unworn = Eigen::Vector2d(0.1, 0.5);
  course.curve = {{0, 0, 2, 3, 0, 1, 0.5}, {1e6, 0.25, 0.5, 1, 0.2, 1, 0.5}};
  course.worn = {Eigen::Vector2d::Zero(), Eigen::Vector2d(0, 0.2)};
  course.largest_pressure = {Eigen::Vector2d(2, 3), Eigen::Vector2d(5, 0.5)};
  course.end = fem::WearEnd::rate;
  course.n_jumps = 1;
  course.n_cycles_stepped = 7;
  for (auto* period : {&course.first, &course.last}) {
    period->slip = Eigen::Matrix2d{{0, 0}, {1, -1}};
    period->pressure = Eigen::Matrix2d{{2, 1}, {1, 3}};
    period->largest_pressure = Eigen::Vector2d(2, 3);
  }
  course.last.pressure(1, 0) = 0;
  wear.distance_shakedown = {0.3, 0.01};
  wear.distance_first_slip = {0.4, 0.2};
  wear.pressed_outside = 0.125;
  wear.cost.computations = 9;
  wear.slip_is_proved = false;
  wear.largest_springs_difference = 0.25;
  wear.springs_error = 0.125;
  return wear;
}

TEST(WearJson, IsInSiUnits) {
  const auto json = to_json(made_up_wear(), units);
  EXPECT_EQ(json["cycles"], (std::vector<double>{0, 1e6}));
  EXPECT_DOUBLE_EQ(json["volume"][1], 0.25 * 1e-10);
  EXPECT_DOUBLE_EQ(json["volume_rate"][1], 0.5 * 1e-10);
  EXPECT_DOUBLE_EQ(json["deepest"][1], 0.2e-4);
  EXPECT_DOUBLE_EQ(json["friction_work"][0], 3 * 0.1 * 1e-4) << "1e6 Pa 1e-4 m 1e-3 m, times 1e-4 m";
  EXPECT_DOUBLE_EQ(json["stick_radius"][1], 5e-4);
  EXPECT_DOUBLE_EQ(json["contact_radius"][1], 1e-3);
  EXPECT_DOUBLE_EQ(json["r"][1], 7.5e-4);
  EXPECT_DOUBLE_EQ(json["worn_depth"][1], 2e-5);
  EXPECT_EQ(json["distance_to_limit"]["shakedown"], 0.01);
  EXPECT_EQ(json["distance_to_limit"]["first_slip"], 0.2);
  EXPECT_EQ(json["distance_to_shakedown_limit"][0], 0.3);
  EXPECT_EQ(json["end"], "rate fallen");
  EXPECT_EQ(json["ends_in_limit"], false) << "an eighth of the force is pressed outside";
  EXPECT_EQ(json["slip_is_proved"], false);
  EXPECT_EQ(json["springs_difference"], 0.25);
  EXPECT_EQ(json["springs_error"], 0.125);
  EXPECT_EQ(json["sticks_throughout"], false);
  EXPECT_TRUE(json["rate_error"].is_null());
  EXPECT_EQ(json["cost"]["computations"], 9);
  EXPECT_EQ(json["cost"]["cycles_stepped"], 7);
}

TEST(WearJson, HasTheCostWithItsErrorInMetres) {
  auto wear = made_up_wear();
  wear.fe.seconds = 1.25;
  wear.fe.course.largest_jump_error = 0.25;
  wear.cost.bodies = {4, 2};
  EXPECT_EQ(to_json(wear, units)["cost"], nlohmann::ordered_json::parse(R"({
    "seconds": 1.25, "rings": 2, "jumps": 1, "largest_jump_error": 2.5e-5, "cycles_stepped": 7, "computations": 9,
    "bodies": 4, "bodies_from_store": 2})"));
}

TEST(WearJson, ZonesAreATextAStep) {
  const auto zones = to_json(made_up_wear(), units)["zones"];
  EXPECT_EQ(zones["start"], (std::vector<std::string>{"sf", "sb"}));
  EXPECT_EQ(zones["end"], (std::vector<std::string>{"so", "sb"}));
}

TEST(WearJson, WritesTheWornProfileAsATable) {
  const ScratchFolder folder;
  Case input;
  input.name = "ball";
  input.file = "cases/ball.prm";
  write_wear(made_up_wear(), input, units, folder.path());
  std::ifstream profile(folder.path() / "worn_profile.csv");
  std::string header, centre, inner, outer;
  std::getline(profile, header);
  std::getline(profile, centre);
  std::getline(profile, inner);
  std::getline(profile, outer);
  EXPECT_EQ(header, "r [m],f [m]");
  EXPECT_EQ(centre, "0,0");
  EXPECT_EQ(inner, "0.00025,1e-05");
  EXPECT_EQ(outer, "0.00075,7e-05");
  std::ifstream rings(folder.path() / "worn_rings.csv");
  std::getline(rings, header);
  std::getline(rings, inner);
  std::getline(rings, outer);
  EXPECT_EQ(header, "r outer [m],worn depth [m]");
  EXPECT_EQ(inner, "0.00050000000000000001,0");
  EXPECT_EQ(outer, "0.001,2.0000000000000002e-05");
  std::ifstream course(folder.path() / "wear.csv");
  std::getline(course, header);
  EXPECT_EQ(header,
            "r [m],p largest at start [Pa],p largest in the middle [Pa],p largest at end [Pa],f after 0 cycles [m],"
            "f after 1e+06 cycles [m]");
  std::string first_ring;
  std::getline(course, first_ring);
  EXPECT_EQ(first_ring.substr(0, 28), "0.00025,200000,500000,500000") << "half of it is worn at the end";
  std::ifstream goes_on(folder.path() / "ball-worn.prm");
  std::string comment, include;
  std::getline(goes_on, comment);
  std::getline(goes_on, include);
  EXPECT_EQ(include, "include " + std::filesystem::absolute("cases/ball.prm").string());
}

// The rings take the place of the heights that the case began on.
TEST(WearJson, GoesOnFromTheRingsOfACaseThatBeganOnHeights) {
  const ScratchFolder folder;
  folder.write("worn.csv", "r [m],f [m]\n0,0\n1e-3,6e-5\n2e-3,2e-4\n");
  const auto file = folder.write("ball.prm", wearing_text("  set Coefficient = 1e-12\n  set Profile = worn.csv\n"));
  const auto input = read_case_file(file).front();
  ASSERT_FALSE(input.wear_kinetics->profile.empty());
  write_wear(made_up_wear(), input, units, folder.path());
  const auto goes_on = read_case_file(folder.path() / "ball-worn.prm").front();
  EXPECT_TRUE(goes_on.wear_kinetics->profile.empty());
  EXPECT_NE(goes_on.wear_kinetics->rings.find("worn_rings.csv"), std::string::npos);
}

// The file of a point of a sweep is that of the whole sweep, and cannot be gone on with.
TEST(WearJson, WritesNoCaseToGoOnForAPointOfASweep) {
  const ScratchFolder folder;
  Case input;
  input.name = "ball";
  input.file = "cases/ball.prm";
  input.sweep = Case::Sweep{"ball", "Motion / Phase", 0};
  write_wear(made_up_wear(), input, units, folder.path());
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "worn_profile.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "ball-worn.prm"));
}

/// Two rings with four angles around the axis, of which a mirror leaves two; the outer ring wears.
ProvedSurfaceWear made_up_surface_wear() {
  ProvedSurfaceWear wear{{}, {}, {}, wear_limit(mdr::limiting_profile(mdr::parabola(1e-2), 5e-4, 1e-4))};
  auto& fe = wear.fe;
  fe.grid = fem::angular_grid(4, fem::Mirrors::x);
  fe.radii = {0, 0.5, 1};
  fe.unworn = Eigen::Vector2d(0.1, 0.5);
  fe.course.curve = {{0, 0, 2, 3, 0, 1, 0.5}, {1e6, 0.25, 0.5, 1, 0.2, 1, 0.5}};
  fe.course.worn = {Eigen::Vector4d::Zero(), Eigen::Vector4d(0, 0.2, 0, 0.3)};
  fe.course.last.largest_pressure = Eigen::Vector4d(2, 0, 2, 0.5);
  fe.course.end = fem::WearEnd::rate;
  fe.sticks = fem::region_within(fe.grid, Eigen::Vector2d(0.5, 0.5));
  return wear;
}

TEST(SurfaceWearJson, IsInSiUnits) {
  auto wear = made_up_surface_wear();
  auto json = to_json(wear, units);
  EXPECT_EQ(json["cycles"], (std::vector<double>{0, 1e6}));
  EXPECT_DOUBLE_EQ(json["volume"][1], 0.25 * 1e-10);
  EXPECT_EQ(json["end"], "rate fallen");
  EXPECT_DOUBLE_EQ(json["sticks"]["radius"], 5e-4);
  EXPECT_NEAR(json["sticks"]["area"], 7.853982e-7, 1e-12);
  EXPECT_DOUBLE_EQ(json["sticks"]["across"], 5e-4);
  EXPECT_TRUE(json["sticks"]["radius_bar"].is_null());
  EXPECT_DOUBLE_EQ(json["limit_of_mdr"]["stick_radius"], 5e-4);
  wear.is_proved = true;
  wear.radius.add(ErrorSource::rings, 0.125);
  wear.volume.add(ErrorSource::rings, 0.5);
  json = to_json(wear, units);
  EXPECT_DOUBLE_EQ(json["sticks"]["radius_bar"], 1.25e-4);
  EXPECT_NEAR(json["sticks"]["area_bar"], 3.926991e-7, 1e-12) << "2 pi 0.5 mm 0.125 mm";
  EXPECT_DOUBLE_EQ(json["volume_bar"], 0.125e-10);
}

TEST(SurfaceWearJson, HasEachBarAndTheLimitOfItsOwn) {
  auto wear = made_up_surface_wear();
  wear.is_proved = true;
  wear.radius.add(ErrorSource::rings, 0.125);
  wear.along.add(ErrorSource::rings, 0.25);
  wear.across.add(ErrorSource::rings, 0.5);
  const auto json = to_json(wear, units);
  EXPECT_DOUBLE_EQ(json["sticks"]["radius_bar"], 1.25e-4);
  EXPECT_DOUBLE_EQ(json["sticks"]["along_bar"], 2.5e-4);
  EXPECT_DOUBLE_EQ(json["sticks"]["across_bar"], 5e-4);
  EXPECT_DOUBLE_EQ(json["limit_of_mdr"]["volume"],
                   mdr::worn_volume(mdr::limiting_profile(mdr::parabola(1e-2), 5e-4, 1e-4)));
}

// Of the points of either ring by their first, above the x axis on the right.
TEST(SurfaceWearJson, WritesHeightsAndPressuresInSiUnits) {
  const ScratchFolder folder;
  write_surface_wear(made_up_surface_wear(), units, folder.path());
  for (const auto& [name, inner, outer] : {std::tuple{"r inner [m]", 0.0, 5e-4},
                                           {"r outer [m]", 5e-4, 1e-3},
                                           {"angle [rad]", std::acos(-1.0) / 4, std::acos(-1.0) / 4},
                                           {"f unworn [m]", 1e-5, 5e-5},
                                           {"f worn [m]", 1e-5, 7e-5},
                                           {"p largest at end [Pa]", 2e5, 0.0}}) {
    const auto values = read_columns(folder.path() / "worn_surface.csv", name, name).second;
    EXPECT_NEAR(values.at(0), inner, 1e-9 * std::abs(inner)) << name;
    EXPECT_NEAR(values.at(4), outer, 1e-9 * std::abs(outer)) << name;
  }
}

TEST(SurfaceWearJson, WritesThePointsOfTheWholeCircle) {
  const ScratchFolder folder;
  write_surface_wear(made_up_surface_wear(), units, folder.path());
  const auto [angle, worn] = read_columns(folder.path() / "worn_surface.csv", "angle [rad]", "f worn [m]");
  EXPECT_EQ(angle.size(), 8U);
  const std::vector<double> expected{1e-5, 1e-5, 1e-5, 1e-5, 7e-5, 8e-5, 8e-5, 7e-5};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(worn[i], expected[i], 1e-12) << i;
  const auto outer = read_columns(folder.path() / "worn_surface.csv", "angle [rad]", "r outer [m]").second;
  EXPECT_DOUBLE_EQ(outer[0], 5e-4);
  EXPECT_DOUBLE_EQ(outer[7], 1e-3);
  const auto pressure = read_columns(folder.path() / "worn_surface.csv", "angle [rad]", "p largest at end [Pa]").second;
  EXPECT_DOUBLE_EQ(pressure[0], 2 * units.pressure());
}

}  // namespace
}  // namespace fretval::wear_json_test
