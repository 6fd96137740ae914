#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "comparison/case/test_duration.h"
#include "comparison/data/path_table.h"
#include "comparison/results/case_result.h"
#include "comparison/results/results_folder.h"
#include "tests/comparison/read_case.h"

namespace fretval::data_files_test {
namespace {

using nlohmann::ordered_json;

TEST(DataFiles, HaveTheTraceAndWhatIsLeftOfIt) {
  const ScratchFolder folder;
  auto input = read_case();
  // Apex at 1 mm, tilt 0.01, f = r²/(2 R) with R = 10 mm.
  Case::AlignedTrace trace{{1e-3, 1e-6, 0.01, 1e-4, 1e-8, false}, {0, 0.5e-3, 1e-3, 1.6e-3, 2e-3}, {}, {}, {}, 1e-8};
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

// Heights that are counted upwards, a tilt of 0.01, and a bump of 30 nm on one of three rows, of which a third is the
// mean.
TEST(DataFiles, HaveWhatIsLeftOfATraceWhoseHeightsGoUpwards) {
  const ScratchFolder folder;
  auto input = read_case();
  Case::AlignedTrace trace{{1e-3, 1e-6, 0.01, 1e-4, 1e-8, true}, {0.5e-3, 0.8e-3, 1.4e-3}, {}, {}, {}, 1e-8};
  for (const double x : trace.x)
    trace.z.push_back(5e-6 - (x - 1e-3) * (x - 1e-3) / 0.02 + 0.01 * (x - 1e-3) + (x == 0.8e-3 ? 3e-8 : 0));
  for (int i = 0; i <= 1000; ++i) {
    trace.r.push_back(1e-6 * i);
    trace.f.push_back(1e-12 * i * i / 0.02);
  }
  input.indenter.trace = trace;
  write_data(input, folder.path());
  const auto residual = read_columns(folder.path() / "trace.csv", "x [m]", "residual [m]").second;
  ASSERT_EQ(residual.size(), 3U);
  EXPECT_NEAR(residual[0], 1e-8, 1e-13);
  EXPECT_NEAR(residual[1], -2e-8, 1e-13);
  EXPECT_NEAR(residual[2], 1e-8, 1e-13);
}

// A file of every row would not be seen, and takes long; without loops there is none.
TEST(DataFiles, HaveSomeOfManyRows) {
  const ScratchFolder folder;
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->tangential_displacement.assign(5000, 1e-6);
  input.measured->tangential_force.assign(5000, 2);
  write_data(input, folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "measured_loops.csv"));
  input.measured->loop = "loops.csv";
  write_data(input, folder.path());
  const auto force = read_columns(folder.path() / "measured_loops.csv", "u_x [m]", "F_x [N]").second;
  EXPECT_LE(force.size(), 2000U);
  EXPECT_GE(force.size(), 1000U);
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
  Case::Path path{{{0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false}, "rig.csv"};
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
      Case::AlignedTrace{{1e-3, 2e-6, 0.01, 1e-4, 3e-8, true}, {0, 1}, {2, 3}, {0, 1, 2}, {0, 1, 2}, 4e-8};
  Case::Path path{{{0, 1, 2}, {1e-4, 1.2e-4, 1.2e-4}, {0, 0, 1e-5}, false}, "rig.csv"};
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

TEST(ModuliFiles, HaveTheBodyAroundItsFrequenciesAndWhatWasMeasured) {
  const ScratchFolder folder;
  auto input = read_case();
  input.elastomer.master_curve = Case::MasterCurve{};
  auto& curve = *input.elastomer.master_curve;
  curve.frequency = {0.01, 1, 100};
  curve.storage = {1e6, 1.3e6, 2e6};
  curve.loss = {1e4, 5e5, 1e4};
  write_moduli(input, mdr::standard_solid(1e6, 1e6, 0.1), folder.path());
  const auto [f, storage] = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G' [Pa]");
  EXPECT_NEAR(f.front(), 1e-3, 1e-12);
  EXPECT_NEAR(f.back(), 1e3, 1e-6);
  EXPECT_NEAR(storage.front() / 1e6, 1, 1e-6);
  EXPECT_NEAR(storage.back() / 2e6, 1, 2e-6);
  const auto loss = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G'' [Pa]").second;
  EXPECT_NEAR(*std::max_element(loss.begin(), loss.end()), 0.5e6, 0.005e6);  // G1/2, at omega tau = 1
  const auto [at, measured] = read_columns(folder.path() / "measured_moduli.csv", "f [Hz]", "G'' [Pa]");
  EXPECT_EQ(at, (std::vector<double>{0.01, 1, 100}));
  EXPECT_EQ(measured, (std::vector<double>{1e4, 5e5, 1e4}));
}

// The valid case oscillates at 1 Hz; the moduli of spring and dashpot are equal at G0/(2 pi eta) = 15.9 Hz.
TEST(ModuliFiles, ReachADecadeBeyondTheFrequencyOfADashpot) {
  const ScratchFolder folder;
  write_moduli(read_case(), mdr::prony(1e6, {}, {}, 1e4), folder.path());
  const auto [f, loss] = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G'' [Pa]");
  EXPECT_NEAR(f.front(), 0.1, 1e-9);
  EXPECT_NEAR(f.back(), 10 * 15.915494309, 1e-6);
  EXPECT_NEAR(loss.back() / 1e7, 1, 1e-8) << "a decade beyond, ten times G0";
}

// The branch of 0.1 s relaxes at 1.59 Hz. A path that takes three hours oscillates at no frequency of its own.
TEST(ModuliFiles, OfAPathAreThoseAroundItsBranches) {
  const ScratchFolder folder;
  auto input = read_case();
  input.motion.path = Case::Path{{{0, 5e3, 1e4}, {1e-4, 1e-4, 1e-4}, {0, 1e-5, 0}, true}, "rig.csv"};
  write_moduli(input, mdr::standard_solid(1e6, 1e6, 0.1), folder.path());
  const auto f = read_columns(folder.path() / "moduli.csv", "f [Hz]", "G' [Pa]").first;
  EXPECT_NEAR(f.front(), 0.15915494309, 1e-9);
  EXPECT_NEAR(f.back(), 15.915494309, 1e-7);
}

TEST(ModuliFiles, OfAnElasticBodyAreNone) {
  const ScratchFolder folder;
  write_moduli(read_case(elastic_case()), mdr::elastic(1e6), folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "moduli.csv"));
}

TEST(MeasuredValues, StandBesideBothMethods) {
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->stick_radius = Case::Measured::Value{0.8e-3, 2e-5};
  const ordered_json fe{{"stick_radius_shakedown", 0.79e-3}}, mdr{{"stick_radius_shakedown", nullptr}};
  const auto json = measured_json(input, fe, mdr);
  const auto& radius = json.at("stick_radius_shakedown");
  EXPECT_EQ(radius.at("value"), 0.8e-3);
  EXPECT_EQ(radius.at("uncertainty"), 2e-5);
  EXPECT_NEAR(radius.at("fe_difference").get<double>(), -1e-5, 1e-18);
  EXPECT_TRUE(radius.at("mdr").is_null() && radius.at("mdr_difference").is_null());
  EXPECT_TRUE(measured_json(read_case(), fe, mdr).is_null());
}

// In a pass it is the zone that never slips which was measured, and no loop is closed. What only pulls presses with
// nothing.
TEST(MeasuredValues, OfAPassAreHeldToWhatNeverSlips) {
  auto input = read_case();
  input.motion.path = Case::Path{{{0, 1}, {1e-4, 1e-4}, {0, 1e-5}, false}, "rig.csv"};
  input.measured = Case::Measured{};
  input.measured->stick_radius = Case::Measured::Value{0.8e-3, 2e-5};
  input.measured->normal_force = {-3, -2};
  input.measured->tangential_displacement = {0, 1e-6};
  input.measured->tangential_force = {2, -3};
  const auto json = measured_json(input, ordered_json::object(), ordered_json::object());
  EXPECT_EQ(json.at("stick_radius_first_slip").at("value"), 0.8e-3);
  EXPECT_FALSE(json.contains("stick_radius_shakedown"));
  EXPECT_FALSE(json.contains("tangential_work"));
  EXPECT_EQ(json.at("normal_force_max").at("value"), 0);
  EXPECT_EQ(json.at("tangential_force_max").at("value"), 3);
}

// A triangle whose last side goes from the last row back to the first.
TEST(MeasuredValues, CloseTheirLoops) {
  auto input = read_case();
  input.measured = Case::Measured{};
  input.measured->tangential_displacement = {0, 2e-6, 2e-6};
  input.measured->tangential_force = {0, 0, 2};
  const auto json = measured_json(input, ordered_json::object(), ordered_json::object());
  EXPECT_NEAR(json.at("tangential_work").at("value").get<double>(), 2e-6, 1e-18);
}

// The area of an ellipse of half axes 2e-6 m and 3 N.
TEST(MeasuredValues, ComeOutOfLoops) {
  auto input = read_case();
  input.measured = Case::Measured{};
  auto& measured = *input.measured;
  constexpr int n = 720;
  for (int i = 0; i < n; ++i) {
    const double phase = 2 * M_PI * i / n;
    measured.tangential_displacement.push_back(2e-6 * std::cos(phase));
    measured.tangential_force.push_back(3 * std::sin(phase) - 0.5);
    measured.normal_force.push_back(5 + std::cos(phase));
  }
  const auto json = measured_json(input, {{"normal_force_max", 6.5}}, ordered_json::object());
  EXPECT_NEAR(json.at("tangential_work").at("value").get<double>() / (M_PI * 6e-6), 1, 1e-4);
  EXPECT_NEAR(json.at("tangential_force_max").at("value").get<double>(), 3.5, 1e-4);
  EXPECT_NEAR(json.at("normal_force_max").at("fe_difference").get<double>(), 0.5, 1e-12);
}

}  // namespace
}  // namespace fretval::data_files_test
