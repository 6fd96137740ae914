#include "comparison/results/surface_wear_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "comparison/results/results_folder.h"
#include "mdr/profiles/profile.h"
#include "mdr/stick/limiting_profile.h"
#include "tests/comparison/scratch_folder.h"

namespace fretval::surface_wear_json_test {
namespace {

const Units units{1e-3, 1e-4, 1e6, 6.0};  // m, m, Pa, rad/s

/// Two rings with four angles around the axis, of which a mirror leaves two; the outer ring wears.
ProvedSurfaceWear made_up_wear() {
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
  auto wear = made_up_wear();
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
  auto wear = made_up_wear();
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
  write_surface_wear(made_up_wear(), units, folder.path());
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
  write_surface_wear(made_up_wear(), units, folder.path());
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
}  // namespace fretval::surface_wear_json_test
