#include "comparison/results/data_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case/test_duration.h"
#include "comparison/data/path_table.h"
#include "comparison/results/results_folder.h"
#include "tests/comparison/read_case.h"

namespace fretval {
namespace {

TEST(DataFiles, HaveTheTraceAndWhatIsLeftOfIt) {
  const ScratchFolder folder;
  auto input = read_case();
  // Apex at 1 mm, tilt 0.01, f = r²/(2 R) with R = 10 mm.
  Case::AlignedTrace trace{{0, 0.5e-3, 1e-3, 1.6e-3, 2e-3}, {}, 1e-3, 1e-6, 0.01, 1e-4, 1e-8, false, {}, {}, 1e-8};
  for (const double x : trace.x) trace.z.push_back((x - 1e-3) * (x - 1e-3) / 0.02 + 0.01 * (x - 1e-3));
  for (int i = 0; i <= 1000; ++i) {
    trace.r.push_back(1e-6 * i);
    trace.f.push_back(1e-12 * i * i / 0.02);
  }
  input.indenter.trace = trace;
  write_data(input, folder.path());
  const auto [x, z] = read_columns(folder.path() / "trace.csv", "x [m]", "z [m]");
  EXPECT_EQ(x, trace.x);
  const auto residual = read_columns(folder.path() / "trace.csv", "x [m]", "residual [m]").second;
  EXPECT_TRUE(std::isnan(residual.front()));  // as far out as the profile goes, and no further
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(residual[i], 0, 1e-13);
  EXPECT_EQ(read_columns(folder.path() / "aligned_profile.csv", "r [m]", "f [m]").first.size(), 1001U);
  const auto json = data_json(input);
  EXPECT_EQ(json["trace"]["apex"], 1e-3);
  EXPECT_NEAR(json["trace"]["tilt"].get<double>(), 0.57294, 1e-4);
  EXPECT_EQ(json["trace"]["heights"], "downwards");
}

TEST(DataFiles, HaveTheLoopsThatWereMeasured) {
  const ScratchFolder folder;
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->loop = "loops.csv";
  input.measured->tangential_displacement = {0, 1e-6};
  input.measured->tangential_force = {2, 3};
  write_data(input, folder.path());
  const auto [u, force] = read_columns(folder.path() / "measured_loops.csv", "u_x [m]", "F_x [N]");
  EXPECT_EQ(u, (std::vector<double>{0, 1e-6}));
  EXPECT_EQ(force, (std::vector<double>{2, 3}));
}

TEST(DataFiles, SayWhatWasMadeOfTheData) {
  auto input = read_case();
  EXPECT_TRUE(data_json(input).empty());
  limit_to_test(0.01, input);
  input.elastomer.shore_a = 40;
  Case::Path path{"rig.csv", {0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false};
  path.reduction = Case::PathReduction{300'000, 7, 1e-8, 2e-8};
  input.motion = motion_along(path);
  const auto json = data_json(input);
  EXPECT_EQ(json["test_duration"]["slow_branches"], 1);
  EXPECT_EQ(json["hardness"]["shore_a"], 40);
  EXPECT_EQ(json["record"]["rows"], 300'000);
  EXPECT_EQ(json["record"]["rows_before_contact"], 7);
  EXPECT_EQ(json["record"]["tangential_error"], 2e-8);
}

TEST(DataFiles, HaveEveryColumnOfTheLoops) {
  const ScratchFolder folder;
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->loop = "loops.csv";
  input.measured->time = {1, 2};
  input.measured->indentation = {3, 4};
  input.measured->tangential_displacement = {5, 6};
  input.measured->normal_force = {7, 8};
  input.measured->tangential_force = {9, 10};
  write_data(input, folder.path());
  double next = 1;
  for (const char* name : {"t [s]", "d [m]", "u_x [m]", "F_N [N]", "F_x [N]"}) {
    EXPECT_EQ(read_columns(folder.path() / "measured_loops.csv", name, name).second,
              (std::vector<double>{next, next + 1}))
        << name;
    next += 2;
  }
}

// A tilt of 1 %, which is atan(0.01) in degrees, known to 1e-4 rad.
TEST(DataFiles, SayEveryNumberOfTheDataUnderItsKey) {
  auto input = read_case();
  input.indenter.trace =
      Case::AlignedTrace{{0, 1}, {2, 3}, 1e-3, 2e-6, 0.01, 1e-4, 3e-8, true, {0, 1, 2}, {0, 1, 2}, 4e-8};
  Case::Path path{"rig.csv", {0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false};
  path.reduction = Case::PathReduction{300'000, 7, 1e-8, 2e-8, 20, 5e-8, 6e-8};
  input.motion.path = path;
  input.elastomer.test_duration = Case::TestDuration{3600, 2e5, {1, 2}, {3, 4}, 0, 21, 22, {0.5}, 7e-5};
  input.elastomer.shore_a = 40;
  input.elastomer.modulus_scatter = 0.2;
  auto json = data_json(input);
  EXPECT_NEAR(json["trace"]["tilt"].get<double>(), 0.572938697683, 1e-11);
  EXPECT_NEAR(json["trace"]["tilt_uncertainty"].get<double>(), 5.7295779513e-3, 1e-12);
  for (const char* key : {"tilt", "tilt_uncertainty"}) json["trace"].erase(key);
  EXPECT_EQ(json, nlohmann::ordered_json::parse(R"({
    "trace": {"apex": 1e-3, "apex_uncertainty": 2e-6, "noise": 3e-8, "heights": "upwards", "rows": 2},
    "record": {"rows": 300000, "rows_kept": 3, "rows_before_contact": 7, "normal_error": 1e-8,
      "tangential_error": 2e-8, "cycles": 20, "normal_scatter": 5e-8, "tangential_scatter": 6e-8},
    "test_duration": {"duration": 3600.0, "relaxed_modulus_of_data": 2e5, "branches_of_data": 2, "slow_branches": 21,
      "merged_branches": 22, "merging_error": 7e-5, "near_times": [0.5]},
    "hardness": {"shore_a": 40.0, "scatter": 0.2}})"));
}

}  // namespace
}  // namespace fretval
